# SPDX-License-Identifier: Apache-2.0
"""The settings that the program declares, as `ilot run --print-config` prints them: fields of forms, without QGIS."""
import dataclasses
import re

SECTION = re.compile(r"^\[(\w+)\]$")
VALUE = re.compile(r"^(\w+) = (.*)$")
RANGE = re.compile(r"^(-?[\d.]+(?:e-?\d+)?) to (-?[\d.]+(?:e-?\d+)?)(?: (.+))?$")
WORDS = re.compile(r"^\w+(, \w+)+$")


@dataclasses.dataclass(frozen=True)
class Field:
    """One setting. kind: boolean, integer, number, choice or text; text is a list, or what may also be auto."""
    key: str
    help: str
    default: str  # as TOML
    kind: str
    minimum: float = 0.0
    maximum: float = 0.0
    unit: str = ""
    choices: tuple = ()
    optional: bool = False
    advanced: bool = False


def _field(key, comment, default, advanced):
    meaning = comment.rsplit(" [", 1)[0]
    optional = meaning.endswith(' or "auto"')
    meaning = meaning.removesuffix(' or "auto"')
    text, _, allowed = meaning.rpartition("; ")
    limits, words = RANGE.match(allowed), WORDS.match(allowed)
    common = {"key": key, "default": default, "optional": optional, "advanced": advanced}
    if words and text:
        return Field(help=text, kind="choice", choices=tuple(allowed.split(", ")), **common)
    if limits and text:
        low, high = float(limits[1]), float(limits[2])
        kind = "text" if default.startswith("[") else "integer" if re.fullmatch(r"-?\d+", default) else "number"
        return Field(help=text, kind=kind, minimum=low, maximum=high, unit=limits[3] or "", **common)
    if default in ("true", "false") or optional and not allowed.startswith("["):
        return Field(help=meaning, kind="boolean", **common)
    return Field(help=meaning, kind="text", **common)


def fields_of(config):
    """Returns the Field of every setting of the text that --print-config prints, in its order."""
    section, comment, advanced, fields = "", "", False, []
    for line in config.splitlines():
        if line.startswith("# Advanced:"):
            advanced = True
        elif line.startswith("# "):
            comment = line[2:]
        elif SECTION.match(line):
            section, advanced = SECTION.match(line)[1] + ".", False
        elif VALUE.match(line):
            name, default = VALUE.match(line).groups()
            fields.append(_field(section + name, comment, default, advanced))
    return fields
