"""Compiles the kernels of capwalk-gpu by the Slang compiler inside PyPI's slangpy, without a
device: `kernels.py FOLDER`, where FOLDER has `queries.slang`.

Slang writes no `double` in WGSL ("unexpected: 'double' type emitted", 2026.12), which wgpu
reads as `f64`. So the source is compiled with `half` for it, which it uses for nothing else,
and here that becomes `f64`.
"""

import ctypes
import glob
import importlib.metadata
import os
import re
import sys

import slangpy

ENTRIES = ["first_hit", "occluded", "closest", "gather"]
PRECISIONS = ["single", "double"]


def compiler():
    """The library inside the package, with the functions that return pointers."""
    folder = os.path.dirname(slangpy.__file__)
    paths = [path for name in ("libslang-compiler*.so*", "slang-compiler.dll", "libslang-compiler*.dylib")
             for path in sorted(glob.glob(os.path.join(folder, name)))]
    if not paths:
        sys.exit("error: slangpy has no Slang compiler in its folder")
    library = ctypes.CDLL(paths[0])
    for name in ("spCreateSession", "spCreateCompileRequest", "spGetDiagnosticOutput",
                 "spGetEntryPointCode", "spGetBuildTagString"):
        getattr(library, name).restype = ctypes.c_void_p
    return library


def text(pointer, *length):
    return ctypes.string_at(pointer, *length).decode() if pointer else ""


def compile_entry(library, source, entry, precision):
    """The kernel in WGSL."""
    session = ctypes.c_void_p(library.spCreateSession(ctypes.c_char_p(None)))
    request = ctypes.c_void_p(library.spCreateCompileRequest(session))
    words = [source, "-D" + precision.upper(), "-target", "wgsl", "-entry", entry, "-stage", "compute"]
    arguments = (ctypes.c_char_p * len(words))(*[word.encode() for word in words])
    failed = library.spProcessCommandLineArguments(request, arguments, len(words)) < 0
    failed = failed or library.spCompile(request) < 0
    said = text(library.spGetDiagnosticOutput(request)).strip()
    if said:
        print(said)
    size = ctypes.c_size_t()
    code = None if failed else library.spGetEntryPointCode(request, 0, ctypes.byref(size))
    if not code:
        sys.exit(f"error: {entry} in {precision} precision was not compiled")
    return text(code, size.value)


def in_double(code):
    """`f64` for `f16`, and its literals."""
    code = code.replace("enable f16;\n", "").replace("f16", "f64")
    return re.sub(r"(?<=[\d.])h\b", "lf", code)


def checksum(content):
    """FNV-1a with 64 bits, as a test of the crate computes it."""
    value = 0xCBF29CE484222325
    for byte in content:
        value = (value ^ byte) * 0x100000001B3 % 2**64
    return f"{value:016x}"


def main():
    folder = sys.argv[1]
    source = os.path.join(folder, "queries.slang")
    with open(source, "rb") as file:
        of_source = checksum(file.read())
    library = compiler()
    version = text(library.spGetBuildTagString())
    package = importlib.metadata.version("slangpy")
    for entry in ENTRIES:
        for precision in PRECISIONS:
            code = compile_entry(library, source, entry, precision)
            if precision == "double":
                code = in_double(code)
            code = code.strip() + "\n"
            head = (
                "// Compiled from queries.slang by `cargo xtask kernels`. Not to be edited.\n"
                f"// compiler: Slang {version} in slangpy {package}\n"
                f"// source: {of_source}\n"
                f"// result: {checksum(code.encode())}\n"
            )
            path = os.path.join(folder, f"{entry}_{precision}.wgsl")
            with open(path, "w", encoding="utf-8", newline="\n") as file:
                file.write(head + "\n" + code)
            print(f"    {os.path.basename(path)}: {len(code)} bytes")


main()
