"""Our least squares alone: a process that is kept running and solves once whenever it is asked."""

import ctypes
import json
import subprocess
import time

import numpy as np

import native

LIBC = ctypes.CDLL(None)


class Alone:
    """`coefficients` are the model's own; `starts[flight, sample]` are states by the markers alone, NaN where too few follow."""

    def __init__(self, program, dataset, *options):
        self.process = subprocess.Popen([program, dataset, *options], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        said = json.loads(self.process.stdout.readline())
        self.coefficients = np.array([said["coefficients"][name] for name in native.COEFFICIENTS])
        row = lambda state: [state[name] for name in native.disc.STATES] if state else [np.nan] * native.NX
        self.starts = np.array([[row(state) for state in flight] for flight in said["starts"]])
        clock = ctypes.c_int()
        LIBC.clock_getcpuclockid(self.process.pid, ctypes.byref(clock))
        self.clock = clock.value

    def begin(self, unknowns, sigma):
        """Where each solution begins: coefficients, then the flights' initial states; and the noise, m."""
        coefficients, own = unknowns[: native.NC], unknowns[native.NC :].reshape(-1, native.NX)
        named = [dict(zip(native.disc.STATES, state)) for state in own]
        self.tell(json.dumps({"coefficients": dict(zip(native.COEFFICIENTS, coefficients)), "initial": named, "sigma": sigma}))

    def tell(self, line):
        self.process.stdin.write(line + "\n")
        self.process.stdin.flush()

    def solve(self):
        """Coefficients, what is said of them, and seconds: of the solution, and of all processors."""
        cpu = time.clock_gettime(self.clock)
        self.tell("")
        found = json.loads(self.process.stdout.readline())
        cpu = time.clock_gettime(self.clock) - cpu
        values = np.array([found["coefficients"][name] for name in native.COEFFICIENTS])
        return values, f"{found['steps']} steps" + ("" if found["converged"] else ", not converged"), found["seconds"], cpu
