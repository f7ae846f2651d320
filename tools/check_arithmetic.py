#!/usr/bin/env python3
"""Fails where a public function that makes, places, combines, checks, rounds or certifies solids computes in
whatever arithmetic its caller has set: it has to have a UsualArithmetic (dupin/kernel/parallel.h), or to be one call of
another such function. What it makes, its return type, tells which functions these are."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
ROOMS = ["kernel", "blends", "io"]
# Solids, meshes with a proof, and what is said or proved of either.
MADE = ("Solid|Settled|Repaired|Simplified|Remeshed|Filled|Rounded|RoundedApart|PlacedMesh|Report|CrossCheck|"
        "Built|Certificate|CertifiedInputs|BillOfMaterials")
EXEMPT = {"renamed"}  # computes nothing
DECLARED = re.compile(rf"(?:^|\s)(?:{MADE})\s+(\w+)\(")
# On one line, or up to the brace that stands at a line's beginning.
DEFINED = re.compile(rf"^(?:{MADE}) (?:\w+::)?(\w+)\([^;{{]*\{{(?: ([^\n]*)\}}$|\n(.*?)^\}})", re.MULTILINE | re.DOTALL)
UNNAMED = re.compile(r"^namespace \{.*?^\}  // namespace$", re.MULTILINE | re.DOTALL)


def code_of(file):
    return re.sub(r"//[^\n]*(?<!// namespace)$", "", file.read_text(encoding="utf-8"), flags=re.MULTILINE)


def public_names(root):
    headers = [h for room in ROOMS for h in sorted((root / room / "include").rglob("*.h"))]
    return {name for header in headers for name in DECLARED.findall(code_of(header))} - EXEMPT


def faults(root):
    names = public_names(root)
    one_call = re.compile(rf"\s*return (?:std::move\()?(?:\w+\()?(?:dupin::)?(?:{'|'.join(sorted(names))})\b[^;]*;\s*")
    found = []
    for room in ROOMS:
        for source in sorted((root / room / "src").rglob("*.cpp")):
            if source.stem.endswith("_absent"):  # refuses all
                continue
            text = code_of(source)
            if not re.search(r"^namespace dupin \{", text, re.MULTILINE):
                continue  # a folder's own
            blank = UNNAMED.sub(lambda match: "\n" * match.group().count("\n"), text)
            for match in DEFINED.finditer(blank):
                name, body = match.group(1), match.group(2) or match.group(3) or ""
                if name in names and "UsualArithmetic" not in body and not one_call.fullmatch(body):
                    line = blank.count("\n", 0, match.start()) + 1
                    found.append(f"{source.relative_to(root)}:{line}: {name} needs a UsualArithmetic")
    return found


def main():
    found = faults(ROOT)
    print("\n".join(found) if found else "arithmetic: usual")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
