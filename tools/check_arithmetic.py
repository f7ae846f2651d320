#!/usr/bin/env python3
"""Fails where a public function that makes, places, combines, checks, rounds or certifies solids computes in
whatever arithmetic its caller has set, or reads or writes numbers in it: it has to have a UsualArithmetic
(dupin/kernel/parallel.h), or to be one call of another such function. What it makes, its return type, tells which
functions these are, and of those that read and write their names."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
ROOMS = ["kernel", "blends", "io"]
# Solids, meshes with a proof, and what is said or proved of either.
MADE = ("Solid|Settled|Repaired|Simplified|Remeshed|Filled|Rounded|RoundedApart|PlacedMesh|Report|CrossCheck|"
        "Built|Certificate|CertifiedInputs|BillOfMaterials")
MADE_NAMES = r"(?:read|parse)_\w+|\w+_(?:text|bytes|json|html|svg|pdf|png|csv)|to_(?:json|csv)|document_of|with_chain"
# Compute nothing.
EXEMPT = {"renamed", "read_file", "read_standard_input", "string_json", "error_json", "page_report_json", "reason_text",
          "is_graph_text", "is_pcf_text"}
DECLARED = [re.compile(rf"(?:^|\s)(?:{MADE})\s+(\w+)\("),
            re.compile(rf"^(?:\[\[nodiscard\]\] )?[\w:<>]+ ({MADE_NAMES})\(", re.MULTILINE)]
# On one line, or up to the brace that stands at a line's beginning.
DEFINED = re.compile(rf"^(?:(?:{MADE}) (?:\w+::)?(?P<made>\w+)|[\w:<>]+ (?P<named>{MADE_NAMES}))"
                     rf"\([^;{{]*\{{(?: (?P<line>[^\n]*)\}}$|\n(?P<lines>.*?)^\}})", re.MULTILINE | re.DOTALL)
UNNAMED = re.compile(r"^namespace \{.*?^\}  // namespace$", re.MULTILINE | re.DOTALL)


def code_of(file):
    return re.sub(r"//[^\n]*(?<!// namespace)$", "", file.read_text(encoding="utf-8"), flags=re.MULTILINE)


def public_names(root):
    headers = [h for room in ROOMS for h in sorted((root / room / "include").rglob("*.h"))]
    return {name for header in headers for declared in DECLARED for name in declared.findall(code_of(header))} - EXEMPT


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
                name, body = match["made"] or match["named"], match["line"] or match["lines"] or ""
                if body.strip() == "refuse();":  # where a library is absent
                    continue
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
