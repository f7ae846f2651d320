"""Options of the tool are in manual pages, completions and documents, and those that documents name exist."""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
OPTION = re.compile(r"(?<![\w-])--[a-z][\w-]*")
# Of other programs and of scripts, by the document that names them.
FOREIGN = {
    "CONTRIBUTING.md": "--build --preset --since",
    "benchmarks.md": "--build --cases --limit --preset --repetitions",
    "clients.md": "--info --no-install-recommends --no-render --raw --verbose --write",
    "python.md": "--config-settings --system-site-packages",
    "robustness.md": "--preset",
    "tutorial.md": "--build",
}


def listed(help_text):
    """The long options in the left column of a help's list."""
    rows = re.findall(r"^  (-\S.*?)(?:  |$)", help_text.partition("Options:\n")[2], re.M)
    return set(OPTION.findall(" ".join(rows)))


def main(tool):
    def run(*arguments):
        return subprocess.run([tool, *arguments], capture_output=True, text=True, check=True).stdout

    general = run("--help")
    commands = re.findall(r"^  (\w+)  ", general.partition("Subcommands:\n")[2].partition("\n\n")[0], re.M)
    common = listed(general)
    options = {command: listed(run(command, "--help")) for command in commands}
    everywhere = common.union(*options.values())
    faults = []
    if len(commands) < 20 or len(everywhere) < 50:
        faults.append(f"found {len(commands)} commands and {len(everywhere)} options only")

    completions = {shell: run("completion", shell) for shell in ("bash", "zsh", "fish")}
    for command in commands:
        page = run("manual", command).replace("\\-", "-")
        for option in sorted(options[command]):
            if f"\\fB{option}\\fR" not in page:
                faults.append(f"manual {command}: no {option}")
            for shell, script in completions.items():
                name = option if shell != "fish" else f"-l {option[2:]}"
                if not re.search(re.escape(name) + r"(?![\w-])", script):
                    faults.append(f"completion {shell}: no {option} of {command}")

    documents = [*sorted((ROOT / "docs").glob("*.md")), ROOT / "README.md", ROOT / "CONTRIBUTING.md"]
    for document in documents:
        foreign = set(FOREIGN.get(document.name, "").split())
        for number, line in enumerate(document.read_text().split("\n"), 1):
            for option in OPTION.findall(line):
                if option not in everywhere | foreign:
                    faults.append(f"{document.name}:{number}: no command has {option}")
            for command, rest in re.findall(r"dupin (\w+)( [^`|;&#\n]*)", line):
                for option in OPTION.findall(rest) if command in options else []:
                    if option not in options[command] | common:
                        faults.append(f"{document.name}:{number}: {command} has no {option}")
    text = "\n".join(document.read_text() for document in documents)
    short = {"--output": "-o", "--jobs": "-j"}
    faults += [f"no document names {option}" for option in sorted(everywhere - {"--help", "--version"})
               if not re.search(r"(?<![\w-])" + short.get(option, option) + r"(?![\w-])", text)]
    print("\n".join(faults))
    return 1 if faults else 0


sys.exit(main(sys.argv[1]))
