#!/usr/bin/env python3
"""Shows Doxygen a header the way the project means it: the comment at the head of a header describes the file and the class
of its name, and a comment behind a member describes that member."""
import pathlib
import re
import sys

path = pathlib.Path(sys.argv[1])
lines = path.read_text(encoding="utf-8").splitlines()
name = path.stem.replace("_", "")

head = []
for line in lines[1:]:
    if not line.startswith("//"):
        break
    head.append(line[2:].strip())

out = []
for i, line in enumerate(lines):
    declared = re.match(r"(?:class|struct|enum class) (\w+)\b[^;]*$", line)
    if head and declared and declared[1].lower() == name:
        before = len(out) - 1 if not out[-1].startswith("template") else len(out) - 2
        if not out[before].startswith("//"):
            out.insert(before + 1, "/** " + " ".join(head) + " */")  # on one line: numbers of lines stay nearly true
    out.append(re.sub(r"([;}])\s+// ", r"\1 ///< ", line))
if head:
    out[0] = "/** @file\n * " + " ".join(head) + " */"
    del out[1:2]
print("\n".join(out))
