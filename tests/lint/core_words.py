# SPDX-License-Identifier: GPL-3.0-or-later
"""The rule that the window can translate what the core tells a person whom an error stops."""
import re

# What a technician with a camera, a reviewer and an engineer at the window meet.
MET = ("core/base/file.cpp", "core/base/folder.cpp", "core/base/progress.cpp", "core/camera/", "core/jobs/capture/capture_",
       "core/jobs/capture/store_journal.cpp", "core/jobs/export/export_dataset.cpp", "core/jobs/survey/align_survey.cpp",
       "core/photo/picture/integrity.cpp", "core/store/database.cpp", "core/store/survey_store.cpp", "core/survey/room.cpp")
# The work that the window waits for.
WORKED = ("core/align/", "core/dataset/", "core/jobs/", "core/place/", "core/render/", "core/store/")
# What an alignment says of photos, tags and parts of a survey.
ALIGNED = ("core/align/check/", "core/align/free/", "core/align/solve/", "core/align/tags/", "core/jobs/survey/align_",
           "core/jobs/survey/solution_findings.cpp")
WORDS = ("ui/look/core_alignment.cpp", "ui/look/core_errors.cpp", "ui/look/core_words.cpp")
# Sentences for programmers, about options that no field of the window sets; and for people at a command line.
NOT_MET = re.compile(r"\boptions?\b|must lie|must be|time scale|TMPDIR|--|There is no %1 %2|cannot be used: it must|libcurl|^%1 is left|"
                     r"^The %1 cannot be used|^The mask")
STRING = r'"((?:[^"\\]|\\.)*)"'


def arguments(text, opening):
    """The arguments of the call whose bracket opens there."""
    found, depth, begin, at = [], 0, opening + 1, opening
    while at < len(text):
        if text[at] == '"':
            at = re.compile(STRING, re.S).match(text, at).end()
            continue
        depth += (text[at] in "([{") - (text[at] in ")]}")
        if depth == 0 or (text[at] == "," and depth == 1):
            found.append(text[begin:at].strip())
            begin = at + 1
            if depth == 0:
                return found
        at += 1
    return found


def spelled(argument):
    """The sentence that an argument makes, with %1 and so on for values; None for one that a variable holds."""
    pieces = arguments(argument, argument.index("(")) if re.match(r"(?:spherewalk::)?text\(", argument) else [argument]
    sentence, values = "", 0
    for piece in pieces:
        if re.fullmatch(r"(?:%s\s*)+" % STRING, piece, re.S):
            sentence += "".join(re.findall(STRING, piece, re.S)).replace('\\"', '"')
        else:
            values += 1
            sentence += "%%%d" % values
    return sentence if sentence != "%1" else None


def expression(sentence):
    return re.compile(".+?".join(re.escape(part) for part in re.split(r"%\d", sentence)), re.S)


def told(text):
    """(line, sentence) of each error that a source throws, but defects of the program, and of each warning."""
    for match in re.finditer(r"\bError\(ErrorKind::(?!Internal)\w+,|\bwarning\(", text):
        opening = text.index("(", match.start())
        given = arguments(text, opening)
        sentence = spelled(given[-1] if match.group(0).startswith("warning") else given[1])
        if sentence and not NOT_MET.search(sentence):
            for part in re.split(r"(?<=[.!?])\s+(?=[A-Z%])", sentence):
                yield text.count("\n", 0, match.start()) + 1, part


def aligned(text):
    """(line, sentence) of each warning and each flag of a photo that a source adds to a report."""
    for match in re.finditer(r"\b(?:warnings|flags|doubts|said)\.push_back\(|\bwarn\(alignment,|\btell\(|\b(?:doubt|why) = (?=[\"t])", text):
        called = match.group(0)
        if called.endswith("= "):
            end = re.compile(r"(?:%s|[^;\"])*;" % STRING, re.S).match(text, match.end()).end()
            given = [text[match.end():end - 1].strip()]
        else:
            given = arguments(text, text.index("(", match.start()))
        sentence = spelled(given[0] if called == "tell(" else given[-1])
        if sentence and not NOT_MET.search(sentence):
            for part in re.split(r"(?<=[.!?])\s+(?=[A-Z%])", sentence):
                yield text.count("\n", 0, match.start()) + 1, part


def steps(text):
    """(line, words) of each step of which a source reports progress."""
    for match in re.finditer(r"\bprogress\(", text):
        given = arguments(text, match.end() - 1)
        words = spelled(given[1]) if len(given) == 2 and '"' in given[1] else None
        if words:
            yield text.count("\n", 0, match.start()) + 1, words


def core_words(tree):
    known = [sentence for name in WORDS
             for found in re.findall(r'"spherewalk::ui::CoreWords",\s*((?:%s\s*)+)\)' % STRING, tree.sources.get(name, ""), re.S)
             for sentence in ["".join(re.findall(STRING, found[0], re.S)).replace('\\"', '"')]]
    complaints = []
    for name, text in sorted(tree.sources.items()):
        said = list(told(text)) if name.startswith(MET) else []
        said += list(aligned(text)) if name.startswith(ALIGNED) else []
        for line, sentence in said + list(steps(text) if name.startswith(WORKED) else ()):
            asked = expression(sentence)
            if not any(expression(one).fullmatch(sentence) or asked.fullmatch(one) for one in known):
                complaints.append("%s:%d: the window cannot translate %r; add the sentence to one of ui/look/core_*.cpp" % (name, line, sentence))
    return complaints
