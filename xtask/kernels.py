"""Compiles the kernels of a crate by the Slang compiler inside PyPI's slangpy, without a
device: `kernels.py FOLDER MADE`, where FOLDER has some of the sources below, and MADE what Rust makes of its own
constants (`cargo xtask kernels` calls it). For wgpu they become WGSL,
for NVIDIA's driver PTX, by NVIDIA's own compiler of PyPI. All go into one file, `compiled.lzma`:
text, with a line before each kernel that says its file name, its source, the source's checksum and its own.

Slang writes no `double` in WGSL ("unexpected: 'double' type emitted", 2026.12), which wgpu
reads as `f64`. So the source is compiled with `half` for it, which it uses for nothing else,
and here that becomes `f64`.
"""

import concurrent.futures
import ctypes
import glob
import importlib.metadata
import itertools
import lzma
import os
import re
import sys

import nvidia.cuda_nvrtc
import slangpy

# Of each source its kernels.
ENTRIES = {
    "queries": ["first_hit", "occluded", "closest", "gather"],
    "moved": ["moved_triangles", "moved_edges"],
    "bounds": ["bound_triangles", "bound_edges"],
    "render": ["begin_paths", "go_on", "go_on_diffuse"],
    "forward": ["begin_forward", "go_on_forward"],
    "boundary": ["cross_edges", "begin_sides", "add_sides"],
    "boundary_back": ["cross_edges_back", "begin_sides_back", "add_sides_back"],
    "reverse": ["begin_reverse", "go_on_reverse", "go_back"],
    "hits": ["begin_at_hits"],
    "walk": ["walk"],
    "walk_back": ["walk_back"],
}
# Where files are that sources include.
SHARED = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "crates", "gpu", "src", "kernels")
MADE = sys.argv[2]
PRECISIONS = ["single", "double"]
# What the line before a kernel begins with in the pack.
MARK = "//// "
# Larger than a pack, so that each kernel is packed as what differs from those before.
DICTIONARY = 1 << 24
# Volta, 2017; drivers compile it for what there is.
LEAST_ARCHITECTURE = "compute_70"


def compiler():
    """The library inside the package, with the functions that return pointers."""
    folder = os.path.dirname(slangpy.__file__)
    paths = [path for name in ("libslang-compiler*.so*", "slang-compiler.dll", "libslang-compiler*.dylib")
             for path in sorted(glob.glob(os.path.join(folder, name)))]
    if not paths:
        sys.exit("error: slangpy has no Slang compiler in its folder")
    library = ctypes.CDLL(paths[0])
    for name in ("spCreateSession", "spCreateCompileRequest", "spGetDiagnosticOutput",
                 "spGetEntryPointCode", "spGetCompileRequestCode", "spGetBuildTagString"):
        getattr(library, name).restype = ctypes.c_void_p
    return library


def string(pointer, *length):
    return ctypes.string_at(pointer, *length).decode() if pointer else ""


def slang(library, source, entry, precision, target, real):
    """The kernel in WGSL or CUDA's C++, where `real` is the type of exact tests."""
    session = ctypes.c_void_p(library.spCreateSession(ctypes.c_char_p(None)))
    request = ctypes.c_void_p(library.spCreateCompileRequest(session))
    defines = [precision.upper(), target.upper(), "ENTRY_" + entry.upper(), "REAL=" + real]
    words = [source, *["-D" + define for define in defines], "-I", SHARED, "-I", MADE, "-target", target, "-entry", entry,
             "-stage", "compute", "-line-directive-mode", "none"]
    arguments = (ctypes.c_char_p * len(words))(*[word.encode() for word in words])
    failed = library.spProcessCommandLineArguments(request, arguments, len(words)) < 0
    failed = failed or library.spCompile(request) < 0
    said = string(library.spGetDiagnosticOutput(request)).strip()
    if said:
        print(said)
    size = ctypes.c_size_t()
    code = None
    if not failed:
        code = (library.spGetEntryPointCode(request, 0, ctypes.byref(size))
                or library.spGetCompileRequestCode(request, ctypes.byref(size)))
    if not code:
        sys.exit(f"error: {entry} in {precision} precision was not compiled")
    return string(code, size.value)


def wgsl(library, source, entry, precision):
    """The kernel in WGSL. `half` stands for double precision. wgpu needs not be told what is
    used, and counts threads without a sign."""
    real = "float" if precision == "single" else "half"
    code = slang(library, source, entry, precision, "wgsl", real)
    code = re.sub(r"^enable .*\n", "", code, flags=re.M)
    for sign in re.finditer(r"\(vec\d<f\d+>\(0\) - ", code):
        # Slang 2026.12 writes `-(a + b)` of vectors as `0 - a + b`.
        depth, rest = 0, code[sign.end():]
        for at, letter in enumerate(rest):
            depth += (letter == "(") - (letter == ")")
            if depth < 0:
                break
            if depth == 0 and re.match(r" [+-] ", rest[at:]):
                sys.exit(f"error: {entry}: Slang loses the parentheses of a negated sum, `{rest[:at + 20]}`: write `-a - b`")
    code = re.sub(r"(subgroupShuffle\(\w+, )i32\(", r"\1u32(", code)
    if precision == "single":
        return code
    code = code.replace("f16", "f64")
    return re.sub(r"(?<=[\d.])h\b", "lf", code)


def ptx(library, compiler, source, entry, precision):
    """The kernel in PTX. Nothing is fused in double precision, so that answers are the
    CPU's to the last bit; in single precision, where margins are far larger, the driver
    may fuse what it likes, which it does where no rounding is named, and divisions and roots
    may be off by some ulp."""
    real = "float" if precision == "single" else "double"
    code = slang(library, source, entry, precision, "cuda", real)
    program = ctypes.c_void_p()
    if compiler.nvrtcCreateProgram(ctypes.byref(program), code.encode(), entry.encode(), 0, None, None):
        sys.exit("error: NVIDIA's compiler does not start")
    words = ["--gpu-architecture=" + LEAST_ARCHITECTURE, "--std=c++17", "-default-device", "--fmad=false", "-w"]
    options = (ctypes.c_char_p * len(words))(*[word.encode() for word in words])
    failed = compiler.nvrtcCompileProgram(program, len(words), options)
    result = nvrtc_text(compiler, program, "ProgramLog" if failed else "PTX")
    if failed:
        sys.exit(f"error: {entry} in {precision} precision was not compiled to PTX: {result}")
    result = re.sub(r"\b(add|sub|mul)\.rn\.f32\b", r"\1.f32", result)
    result = re.sub(r"\b(div|sqrt)\.rn\.f32\b", r"\1.approx.f32", result)
    # What the headers declare and no kernel uses.
    result = re.sub(r"^\.global .*\n", "", result, flags=re.M)
    lines = [line.rstrip() for line in result.rstrip("\0").splitlines()]
    return "\n".join(line for line in lines if line and not line.startswith("//")) + "\n"


def nvrtc():
    """NVIDIA's compiler, which needs no device."""
    folder = os.path.dirname(nvidia.cuda_nvrtc.__file__)
    paths = [path for name in ("lib/libnvrtc.so.*", "bin/nvrtc64_*.dll") for path in sorted(glob.glob(os.path.join(folder, name)))]
    if not paths:
        sys.exit("error: nvidia-cuda-nvrtc-cu12 has no library in its folder; run this on Linux or Windows")
    return ctypes.CDLL(paths[0])


def nvrtc_text(compiler, program, what):
    size = ctypes.c_size_t()
    getattr(compiler, f"nvrtcGet{what}Size")(program, ctypes.byref(size))
    buffer = ctypes.create_string_buffer(size.value)
    getattr(compiler, f"nvrtcGet{what}")(program, buffer)
    return buffer.value.decode()


def content(folder, name):
    """A source with what it includes in the place of the lines that say so."""
    paths = [os.path.join(place, name) for place in (MADE, folder, SHARED)]
    with open(next(filter(os.path.exists, paths)), "rb") as file:
        return re.sub(rb'#include "(.*)"\n', lambda line: content(folder, line[1].decode()), file.read())


def checksum(content):
    """FNV-1a with 64 bits, as a test of the crate computes it."""
    value = 0xCBF29CE484222325
    for byte in content:
        value = (value ^ byte) * 0x100000001B3 % 2**64
    return f"{value:016x}"


def compiled(task):
    """A kernel in both languages, by the names of their files."""
    source, entry, precision = task
    library = compiler()
    return {
        f"{entry}_{precision}.wgsl": wgsl(library, source, entry, precision),
        f"{entry}_{precision}.ptx": ptx(library, nvrtc(), source, entry, precision),
    }


def main():
    folder = sys.argv[1]
    slang_version = f"Slang {string(compiler().spGetBuildTagString())} in slangpy {importlib.metadata.version('slangpy')}"
    by_both = f"{slang_version}, NVRTC {importlib.metadata.version('nvidia-cuda-nvrtc-cu12')}"
    parts = [f"// Compiled by `cargo xtask kernels`: {by_both}.\n"]
    tasks = [
        (source, entry, precision)
        for name, entries in ENTRIES.items()
        if os.path.exists(source := os.path.join(folder, f"{name}.slang"))
        for entry, precision in itertools.product(entries, PRECISIONS)
    ]
    # A process for each core: the compilers take seconds, on one.
    with concurrent.futures.ProcessPoolExecutor() as processes:
        for (source, _, _), kernels in zip(tasks, processes.map(compiled, tasks), strict=True):
            name = os.path.basename(source)
            of_source = checksum(content(folder, name))
            for file, code in kernels.items():
                code = code.strip() + "\n"
                parts.append(f"{MARK}{file} {name} {of_source} {checksum(code.encode())}\n{code}")
                print(f"    {file}: {len(code)} bytes", flush=True)
    text = "".join(parts).encode()
    filters = [{"id": lzma.FILTER_LZMA1, "preset": 9 | lzma.PRESET_EXTREME, "dict_size": DICTIONARY}]
    packed = lzma.compress(text, lzma.FORMAT_ALONE, filters=filters)
    with open(os.path.join(folder, "compiled.lzma"), "wb") as file:
        file.write(packed)
    print(f"    compiled.lzma: {len(packed)} bytes for {len(text)}")


if __name__ == "__main__":
    main()
