"""The schema accepts the certificates of the examples and refuses what is none."""
import copy
import json
import pathlib
import subprocess
import sys

import jsonschema

ROOT = pathlib.Path(__file__).resolve().parents[2]


def certificate(tool, name):
    run = subprocess.run([tool, "certify", ROOT / "examples" / name, "-o", "-", "-q"], capture_output=True, text=True)
    return json.loads(run.stdout)


def main(tool):
    schema = json.loads((ROOT / "io" / "certificate.schema.json").read_text())
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(schema)
    documents = {name: certificate(tool, name) for name in ("reducer.json", "header.json", "plant-run.json", "cone-to-pipe.json", "crane-hook.json", "jet-engine.json",
                                                                         "oval-duct.json", "pipe-ring.json", "ringed-canal.json", "ucct-arm.json")}
    faults = [f"{name}: {error.message}" for name, document in documents.items() for error in validator.iter_errors(document)]
    for path, value in [(("format",), "dupin certificate 2"), (("parts", 0, "kind"), 1), (("claims", 0, "regular", "verdict"), "likely"),
                        (("claims", 0, "mesh", "segments"), 2), (("clearances", 0, "parts"), [1]), (("sha256",), "0")]:
        document = copy.deepcopy(documents["reducer.json"])
        place = document
        for key in path[:-1]:
            place = place[key]
        place[path[-1]] = value
        if validator.is_valid(document):
            faults.append(f"accepts {path}")
    print("\n".join(faults))
    return 1 if faults else 0


sys.exit(main(sys.argv[1]))
