"""Our library of flights, the flights that all fly, and the clock."""

import ctypes
import time

import numpy as np

FLIGHTS = 4096
# The backhand of crates/flight/releases, with the parameters of its file.
BACKHAND = [-0.903, 0.633, 0.913, 13.109, 0.41, -2.779, -0.0711, -0.211, -5.03, -14.9, 1.48, -54.3]
DISC = [0.175, 0.002352, 0.001219, 0.269, 0.057, 1.23, 9.7935, 0.188, 2.37, 0.15, 1.24, -0.38, -0.005, -0.0004, -3.4e-5, 0, 0, 0]


def pointer(array):
    return array.ctypes.data_as(ctypes.POINTER(ctypes.c_double))


class Ours:
    def __init__(self, path):
        self.library = ctypes.CDLL(str(path))
        double, pointers = ctypes.c_double, ctypes.POINTER(ctypes.c_double)
        self.library.flights.argtypes = [ctypes.c_int, ctypes.c_int, double, double, ctypes.c_size_t, pointers, pointers, pointers]
        self.library.flights.restype = ctypes.c_uint64
        self.disc_places = self.library.disc_places
        self.disc_places.argtypes, self.disc_places.restype = [ctypes.c_void_p], None
        self.disc_states = self.library.disc_states
        self.disc_states.argtypes, self.disc_states.restype = [ctypes.c_bool, ctypes.c_size_t, pointers, pointers], None

    def fly(self, model, method, rtol, atol, starts, parameters):
        ends = np.zeros((len(starts), 13))
        p = np.array(parameters, dtype=float)
        evaluations = self.library.flights(model, method, rtol, atol, len(starts), pointer(starts), pointer(p), pointer(ends))
        return ends, evaluations / len(starts)


def scattered(start, seed):
    """Flights about one, speeds and rates within a tenth; the first is the one."""
    random = np.random.default_rng(seed)
    starts = np.tile(np.array(start, dtype=float), (FLIGHTS, 1))
    starts[1:, 3:6] *= random.uniform(0.9, 1.1, (FLIGHTS - 1, 3))
    starts[1:, 9:] *= random.uniform(0.9, 1.1, (FLIGHTS - 1, 3))
    return np.ascontiguousarray(starts)


def timed(work):
    """Seconds of the processor, since the machine may be shared."""
    start = time.process_time()
    work()
    return time.process_time() - start
