# SPDX-License-Identifier: MIT
"""What must not be in an image: judged by its symbol table and its link map."""
import re

import elf

# The run-time helpers that the compiler may call; all others of the Arm run-time ABI are forbidden, those for
# float and double among them.
ALLOWED_AEABI = re.compile(
    r"__aeabi_(u?idiv(mod)?|[iu]?ldivmod|uldivmod|[il]div0|lmul|llsl|llsr|lasr|u?lcmp|mem(cpy|move|set|clr)[48]?)$")

FORBIDDEN = [
    ("heap", re.compile(r"(malloc|calloc|realloc|free|memalign|aligned_alloc|_?sbrk|_(malloc|free)_r)$|_Zn[wa]|_Zd[la]")),
    ("floating point", re.compile(
        r"__(add|sub|mul|div|neg|eq|ne|lt|le|gt|ge|cmp|unord|fix|fixuns|float|floatun|extend|trunc|pow)\w*[hsdtx]f[0-9a-z]*$")),
    ("floating point", re.compile(r"__aeabi_(c?[fd]|[iul]+2[fd]|h2f)")),
    ("libm", re.compile(
        r"(__(ieee754|kernel)_\w+|a?(sin|cos|tan)h?[fl]?|atan2[fl]?|sincos[fl]?|sqrt[fl]?|cbrt[fl]?|hypot[fl]?|powi?[fl]?|"
        r"exp(2|10|m1)?[fl]?|log(2|10|1p|b)?[fl]?|floor[fl]?|ceil[fl]?|round[fl]?|l?lround[fl]?|l?lrint[fl]?|rint[fl]?|"
        r"trunc[fl]?|fmod[fl]?|fabs[fl]?|ldexp[fl]?|frexp[fl]?|modf[fl]?|fma[fl]?|fmin[fl]?|fmax[fl]?|__errno)$")),
    ("static guards", re.compile(r"__cxa_guard_|_ZGV")),
    ("exceptions", re.compile(r"__cxa_|_Unwind_|__gxx_personality|__aeabi_unwind_|__gcc_personality|_ZSt9terminate|"
                              r"_ZSt\d+__throw_|__register_frame_info|(abort|terminate)$")),
    ("RTTI", re.compile(r"_ZT[IS]|__dynamic_cast")),
    ("C library", re.compile(r"(__libc_\w+|_start|crt0|exit|_exit|atexit|_impure_ptr|s?n?printf|puts|strlen|strcmp)$")),
]

# Archives that bring no library code of their own are the project's and the compiler's integer helpers.
FORBIDDEN_ARCHIVE = re.compile(r"\b(lib(?:c|g|m|nosys|rdimon|stdc\+\+|supc\+\+|c_nano|g_nano)\.a)\((\S+?)\)")
FLOAT_MEMBER = re.compile(r"\blibgcc\.a\(((?:\w*[sdtx]f\w*|ieee754-\w+|\w*eh\w*|unwind\w*|pr-support|libunwind)\.o)\)")


def faults_of_symbols(path):
    """Texts, one a forbidden symbol of the ELF file."""
    faults = []
    for symbol in sorted(set(s.name for s in elf.File(path).symbols())):
        for what, pattern in FORBIDDEN:
            if pattern.match(symbol):
                faults.append(f"{what}: symbol {symbol}")
                break
        else:
            if symbol.startswith("__aeabi_") and not ALLOWED_AEABI.match(symbol):
                faults.append(f"run-time helper that isn't on the list of allowed ones: symbol {symbol}")
    return faults


def faults_of_map(path):
    """Texts, one a forbidden archive member that the link map names as linked."""
    with open(path, errors="replace") as file:
        text = file.read()
    # After this heading comes what is in the image; before it also what was thrown out again.
    _, heading, linked = text.partition("Linker script and memory map")
    if not heading:
        return ["not a link map"]
    members = {f"{m[1]}({m[2]})" for m in FORBIDDEN_ARCHIVE.finditer(linked)}
    members |= {f"libgcc.a({m[1]})" for m in FLOAT_MEMBER.finditer(linked)}
    return [f"link map: {member}" for member in sorted(members)]
