"""Compiles units into shared libraries of C symbols."""

import os
import subprocess
from concurrent.futures import ThreadPoolExecutor

FLAGS = {"strict": ["-O3", "-march=native"], "fast": ["-O3", "-march=native", "-ffast-math"]}

RUST_MANIFEST = """[package]
name = "{name}"
version = "0.0.0"
edition = "2024"
[lib]
crate-type = ["cdylib"]
[dependencies]
wrenfold-traits = "=0.2.0"
[profile.release]
opt-level = 3
lto = "fat"
codegen-units = 1
panic = "abort"
[workspace]
"""
RUST_LIB = """// Arrays as wrenfold's spans, without bounds to check.
pub struct From(pub *const f64);
pub struct To(pub *mut f64);
impl<const R: usize> wrenfold_traits::Span2D<R, 1> for From {
    type ValueType = f64;
    #[inline(always)]
    fn get(&self, i: usize, _: usize) -> f64 { unsafe { *self.0.add(i) } }
}
impl<const R: usize> wrenfold_traits::OutputSpan2D<R, 1> for To {
    type ValueType = f64;
    #[inline(always)]
    fn set(&mut self, i: usize, _: usize, value: f64) { unsafe { *self.0.add(i) = value } }
}
"""


def run(command, **more):
    done = subprocess.run(command, capture_output=True, text=True, **more)
    if done.returncode:
        raise SystemExit(f"{' '.join(map(str, command))}\n{done.stderr[-4000:]}")
    return done.stdout


def jobs():
    return min(4, os.cpu_count() or 1)


def gnu_library(target, parts):
    """`parts`: (unit, symbol, name of its flags). One object each, linked into `target`."""
    work = target.with_suffix("")
    work.mkdir(parents=True, exist_ok=True)

    def compile_one(part):
        unit, symbol, flags = part
        source = work / f"{symbol}.{unit.language}"
        source.write_text(unit.text)
        compiler = "g++" if unit.language == "cpp" else "gcc"
        run([compiler, *FLAGS[flags], "-w", "-fPIC", f"-DSYM={symbol}", "-c", source, "-o", work / f"{symbol}.o"])
        return work / f"{symbol}.o"

    with ThreadPoolExecutor(jobs()) as pool:
        objects = list(pool.map(compile_one, parts))
    run(["g++", "-shared", "-o", target, *objects, "-lm"])


def rust_library(target, parts):
    """One crate, a module for each unit."""
    work = target.with_suffix("")
    (work / "src").mkdir(parents=True, exist_ok=True)
    name = target.stem.removeprefix("lib")
    (work / "Cargo.toml").write_text(RUST_MANIFEST.format(name=name))
    lib = RUST_LIB
    for unit, symbol, _ in parts:
        (work / "src" / f"{symbol}.rs").write_text("#![allow(warnings)]\n" + unit.text.replace("SYM", "function_" + symbol)
                                                   .replace("#[unsafe(no_mangle)]", f'#[unsafe(export_name = "{symbol}")]'))
        lib += f'#[path = "{symbol}.rs"]\nmod module_{symbol};\n'
    (work / "src" / "lib.rs").write_text(lib)
    env = {**os.environ, "RUSTFLAGS": "-C target-cpu=native"}
    run(["cargo", "build", "--release", "--quiet", "--target-dir", work / "target"], cwd=work, env=env)
    target.write_bytes((work / "target" / "release" / target.name).read_bytes())


def library(target, parts):
    (rust_library if parts[0][0].language == "rust" else gnu_library)(target, parts)
