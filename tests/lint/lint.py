#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The rules of the house that a machine can check: lint.py [--root FOLDER] [RULE ...]

Without a rule, all are checked. Each complaint names a file and a cure. The exit status is 1 if there is any.
"""
import argparse
import pathlib
import re
import statistics
import sys

from core_words import core_words

MOST_FILES_IN_FOLDER = 24
MOST_LINES_OF_FILE = 450
MOST_HEADERS_OF_ONE = 15
MOST_FILES = 860
LEAST_MEDIAN_SOURCE = 160
MOST_COLUMNS = 130
# Share of the functions -> the most lines that they may have.
FUNCTION_LINES = ((0.5, 8), (0.9, 23), (0.99, 41))
PRODUCT = ("core", "ui", "app")

# Targets of CMake -> the name in the table of owners. Threads belong to the system and have no row.
THIRD_PARTIES = {
    "OpenSSL::Crypto": "OpenSSL", "nlohmann_json::nlohmann_json": "nlohmann-json", "Eigen3::Eigen": "Eigen",
    "JPEG::JPEG": "libjpeg-turbo", "yaml-cpp": "yaml-cpp", "hwy::hwy": "Highway", "exiv2lib": "exiv2",
    "Ceres::ceres": "Ceres", "meshoptimizer::meshoptimizer": "meshoptimizer", "SQLite::SQLite3": "SQLite", "ZLIB::ZLIB": "zlib", "CURL::libcurl": "libcurl",
    "spherewalk_avahi": "Avahi", "spherewalk_httplib": "cpp-httplib", "spherewalk_cairo": "cairo",
    "spherewalk_rsvg": "librsvg", "spherewalk_spng": "libspng", "spherewalk_three": "three.js", "pybind11::module": "pybind11", "mujoco::mujoco": "MuJoCo", "OpenGL::EGL": "MuJoCo",
}
NO_ROW = {"Threads::Threads"}


class Tree:
    """The files of a source tree, read once."""

    def __init__(self, root):
        self.root = pathlib.Path(root)
        self.sources = {}
        for top in PRODUCT:
            for path in sorted((self.root / top).rglob("*")):
                name = path.relative_to(self.root).as_posix()
                if path.suffix in (".h", ".cpp") and "generated" not in path.parts:
                    self.sources[name] = path.read_text(encoding="utf-8", errors="replace")

    def text(self, name):
        path = self.root / name
        return path.read_text(encoding="utf-8") if path.exists() else ""

    def includes(self, name):
        return re.findall(r'^\s*#\s*(?:include|define HWY_TARGET_INCLUDE) "([^"]+)"', self.sources[name], re.M)

    def resolve(self, name, include):
        """The file that an include of this file means, or None for one outside the product."""
        folder = name.rpartition("/")[0]
        parts = name.split("/")
        places = [folder + "/" + include, include, "app/" + include]
        if parts[0] in ("core", "app"):
            places.append("/".join(parts[:2]) + "/" + include)
        match = re.match(r"spherewalk/(\w+)/", include)
        if match:
            places.append("core/%s/include/%s" % (match.group(1), include))
        return next((place for place in places if place in self.sources), None)


def lines(text):
    return text.count("\n") + (not text.endswith("\n"))


def folder_size(tree):
    folders = {}
    for name in tree.sources:
        folders.setdefault(name.rpartition("/")[0], []).append(name)
    return ["%s: it has %d sources, and %d are allowed; part it into rooms by subject" % (folder, len(names), MOST_FILES_IN_FOLDER)
            for folder, names in folders.items() if len(names) > MOST_FILES_IN_FOLDER]


def file_size(tree):
    return ["%s: it has %d lines, and %d are allowed; split it by subject" % (name, lines(text), MOST_LINES_OF_FILE)
            for name, text in tree.sources.items() if lines(text) > MOST_LINES_OF_FILE]


def headers_of_one(tree):
    """Private headers of core that one file includes, besides the source of the same name."""
    users = {name: set() for name in tree.sources if name.startswith("core/") and name.endswith(".h") and "/include/" not in name}
    for name in tree.sources:
        for include in tree.includes(name):
            header = tree.resolve(name, include)
            if header in users and name != header[:-2] + ".cpp":
                users[header].add(name)
    return {header: next(iter(files)) for header, files in users.items() if len(files) == 1}


def private_headers(tree):
    found = headers_of_one(tree)
    if len(found) <= MOST_HEADERS_OF_ONE:
        return []
    return ["%s: only %s includes it, and at most %d of %d such headers may stay; make it part of that file"
            % (header, user, MOST_HEADERS_OF_ONE, len(found)) for header, user in sorted(found.items())]


def cycle(arrows):
    """The nodes of one cycle of the graph, or nothing. arrows: node -> set of nodes."""
    done, path = set(), []

    def visit(node):
        if node in path:
            return path[path.index(node):] + [node]
        if node in done:
            return None
        path.append(node)
        for other in sorted(arrows.get(node, ())):
            found = visit(other)
            if found:
                return found
        path.pop()
        done.add(node)
        return None

    for node in sorted(arrows):
        found = visit(node)
        if found:
            return found
    return []


def room_of(tree, name):
    """The room of a module's file: (module, room). A public header lies in the room of the source of its name."""
    parts = name.split("/")
    if parts[0] != "core" or len(parts) < 3:
        return None
    if parts[2] != "include":
        return parts[1], parts[2] if len(parts) > 3 else ""
    stem = parts[-1][:-2]
    homes = [other for other in tree.sources if other.startswith("core/%s/" % parts[1]) and other.endswith("/%s.cpp" % stem)]
    return (parts[1], homes[0].split("/")[2] if homes[0].count("/") > 2 else "") if len(homes) == 1 else None


def rooms(tree):
    homes = {name: room_of(tree, name) for name in tree.sources}
    reasons = {}
    for name in tree.sources:
        for include in tree.includes(name) if homes[name] else ():
            other = tree.resolve(name, include)
            home, there = homes[name], homes.get(other)
            if there and home[0] == there[0] and home[1] and there[1] and home[1] != there[1]:
                reasons.setdefault(home[0], {}).setdefault((home[1], there[1]), "%s includes %s" % (name, other))
    complaints = []
    for module, arrows in sorted(reasons.items()):
        graph = {}
        for begin, end in arrows:
            graph.setdefault(begin, set()).add(end)
        found = cycle(graph)
        if found:
            why = "; ".join(arrows[step] for step in zip(found, found[1:]))
            complaints.append("core/%s: its rooms include each other (%s): %s; move one of these includes' reasons to a lower room"
                              % (module, " -> ".join(found), why))
    return complaints


def layers_of(tree):
    text = tree.text("packaging/cmake/SpherewalkModule.cmake")
    found = re.findall(r"^set\(SPHEREWALK_LAYER_(\d+) ([^)]*)\)", text, re.M)
    return {module: int(level) for level, modules in found for module in modules.split()}


def layers(tree):
    level = layers_of(tree)
    complaints = []
    for name in tree.sources:
        parts = name.split("/")
        own = parts[1] if parts[0] == "core" else parts[0]
        for include in tree.includes(name):
            match = re.match(r"spherewalk/(\w+)/", include)
            other = match.group(1) if match else "ui" if include.startswith("ui/") else None
            if own not in level:
                complaints.append("%s: the module %s has no layer; name it in packaging/cmake/SpherewalkModule.cmake" % (name, own))
                break
            if other and other != own and level.get(other, 99) >= level[own]:
                complaints.append("%s: it includes %s of layer %s, and %s is layer %d; only lower layers may be included"
                                  % (name, include, level.get(other, "none"), own, level[own]))
    return complaints


def ui_arrows(tree):
    complaints = []
    for name in tree.sources:
        parts = name.split("/")
        if parts[0] != "ui" or len(parts) < 3:
            continue
        cmake = re.sub(r"#.*", "", tree.text("ui/%s/CMakeLists.txt" % parts[1]))
        match = re.search(r"\bROOMS\s+((?:[a-z_]+\s*)+)", cmake)
        linked = set(match.group(1).split()) if match else set()
        for include in tree.includes(name):
            other = include.split("/")[1] if include.startswith("ui/") and include.count("/") > 1 else parts[1]
            if other != parts[1] and other not in linked:
                complaints.append("%s: it includes %s, and ROOMS of ui/%s/CMakeLists.txt does not name %s; add it there if it is a lower room"
                                  % (name, include, parts[1], other))
    return complaints


def third_party_row(target):
    return "OpenCV" if target.startswith("opencv_") else THIRD_PARTIES.get(target)


def owners(tree):
    page = "resources/docs/architecture.md"
    code = "packaging/cmake/SpherewalkModule.cmake"
    enforced, complaints = {}, []
    for target, modules in re.findall(r'^set\(SPHEREWALK_OWNER_(\S+) "([^"]*)"\)', tree.text(code), re.M):
        row = third_party_row(target)
        if row:
            enforced.setdefault(row, set()).update(modules.split(";"))
        elif target not in NO_ROW:
            complaints.append("%s: %s has no name in the table of owners; name it in THIRD_PARTIES of tests/lint/lint.py" % (code, target))
    stated = {}
    table = re.search(r"^\| third party \|.*\n\|[-| ]*\n((?:\|.*\n?)*)", tree.text(page), re.M)
    for row in table.group(1).splitlines() if table else ():
        cells = [cell.strip() for cell in row.strip("|").split("|")]
        stated[re.split(r"[ ,(]", cells[0])[0]] = {owner.strip(" `") for owner in cells[1].split(",")}
    for name, modules in sorted(enforced.items()):
        given = stated.get(name, set())
        # The table may name the folder of a program within its module: app/python belongs to app.
        covered = {next((module for module in modules if owner == module or owner.startswith(module + "/")), owner) for owner in given}
        if covered != modules:
            complaints.append("%s: the owners of %s are %s, and %s enforces %s; correct the table"
                              % (page, name, ", ".join(sorted(given)) or "not named", code, ", ".join(sorted(modules))))
    for name, given in sorted(stated.items()):
        if name not in enforced and not all(re.match(r"(app|ui|tests|packaging)\b", owner) for owner in given):
            complaints.append("%s: nothing enforces the owner of %s; add SPHEREWALK_OWNER_... to %s" % (page, name, code))
    return complaints


def prose(tree):
    complaints = []
    pages = [tree.root / "README.md"] + sorted((tree.root / "resources/docs").rglob("*.md"))
    for page in (page for page in pages if page.exists()):
        is_code = False
        for number, line in enumerate(page.read_text(encoding="utf-8").splitlines(), 1):
            if line.lstrip().startswith("```"):
                is_code = not is_code
            is_exempt = is_code or line.lstrip().startswith("|") or line.startswith("    ") or re.search(r"https?://|\]\([^)]*\)", line)
            if len(line) > MOST_COLUMNS and not is_exempt:
                complaints.append("%s:%d: the line has %d columns, and %d are allowed; break it"
                                  % (page.relative_to(tree.root).as_posix(), number, len(line), MOST_COLUMNS))
    return complaints


def translations(tree):
    """Every language but English, which has plural forms only, translates the same sentences, and all of them."""
    complaints, sentences = [], {}
    for page in sorted((tree.root / "resources/translations").glob("*.ts")):
        name, text = page.relative_to(tree.root).as_posix(), page.read_text(encoding="utf-8")
        complaints += ["%s: translate %r" % (name, re.search("<source>(.*?)</source>", message, re.S).group(1))
                       for message in re.findall("<message.*?</message>", text, re.S) if 'type="unfinished"' in message]
        if not name.endswith("_en.ts"):
            sentences[name] = set(re.findall("<source>(.*?)</source>", text, re.S))
    wanted = set().union(*sentences.values())
    return complaints + ["%s: it lacks %r; build the target spherewalk_words" % (name, lacking)
                         for name, found in sentences.items() for lacking in sorted(wanted - found)]


def tree_size(tree):
    complaints = []
    if len(tree.sources) > MOST_FILES:
        complaints.append("core, ui and app: they have %d sources, and %d are allowed; merge fragments" % (len(tree.sources), MOST_FILES))
    sizes = [lines(text) for name, text in tree.sources.items() if name.endswith(".cpp")]
    if sizes and statistics.median(sizes) < LEAST_MEDIAN_SOURCE:
        complaints.append("core, ui and app: the median .cpp has %d lines, and at least %d are wanted; merge fragments"
                          % (statistics.median(sizes), LEAST_MEDIAN_SOURCE))
    return complaints


def blanked(text):
    """The text with comments, strings and preprocessor lines blanked, its lines kept."""
    pattern = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<!\w)\'(?:\\.|[^\'\\\n])*\'|^[ \t]*#(?:[^\n]*\\\n)*[^\n]*',
                         re.S | re.M)
    return pattern.sub(lambda match: re.sub(r"[^\n]", " ", match.group(0)), text)


def starts_function(head):
    """Whether this text, which stands between the last statement and a brace, is the head of a function."""
    if re.search(r"\b(namespace|class|struct|union|enum)\b[^()]*$", head) or "(" not in head:
        return False
    if head.count("(") != head.count(")"):
        return False
    if re.search(r"=\s*$", re.sub(r"operator\s*[=!<>]=?", "", head)) or re.search(r"\)\s*=|[\w>\]]\s=\s", re.sub(r"\([^()]*\)", "()", head)):
        return False
    if re.search(r"\)\s*(?:noexcept\s*)?:(?!:)", head): # a constructor's list: its own braces come after names
        return head.rstrip()[-1] in ")}"
    return True


def function_lengths(text):
    """(first line, lines) of each function, the whole of it with its head; a lambda belongs to its function."""
    text = blanked(text)
    found, stack, head_at = [], [], 0
    for match in re.finditer(r"[{};]", text):
        at, sign = match.start(), match.group(0)
        inside = any(kind != "scope" for kind, _ in stack)
        if sign == "{":
            head = text[head_at:at]
            kind = "other"
            if not inside:
                if starts_function(re.sub(r"\b(public|private|protected):", "", head)):
                    kind = "function"
                elif re.search(r"\b(namespace|class|struct|union|extern)\b", head) and "(" not in re.sub(r"alignas\([^)]*\)", "", head):
                    kind = "scope"
            first = head_at + len(head) - len(head.lstrip())
            stack.append((kind, first))
            if kind == "scope":
                head_at = at + 1
        elif sign == "}" and stack:
            kind, first = stack.pop()
            if kind == "function":
                begin = re.match(r"(?:(?:public|private|protected):\s*)*", text[first:]).end() + first
                found.append((text.count("\n", 0, begin) + 1, text.count("\n", begin, at) + 1))
            if kind != "other" and not any(other != "scope" for other, _ in stack):
                head_at = at + 1
        elif sign == ";" and not inside:
            head_at = at + 1
    return found


def functions(tree):
    lengths = sorted((length, name, line) for name, text in tree.sources.items() for line, length in function_lengths(text))
    complaints = []
    for share, most in FUNCTION_LINES:
        if not lengths:
            break
        length, name, line = lengths[min(len(lengths) - 1, int(share * len(lengths)))]
        if length > most:
            complaints.append("%s:%d: %d %% of the functions may have up to %d lines, and this one, at that place, has %d; shorten the longest ones"
                              % (name, line, 100 * share, most, length))
    return complaints


RULES = {rule.__name__: rule for rule in
         (folder_size, file_size, private_headers, rooms, layers, ui_arrows, owners, prose, translations, core_words, tree_size, functions)}


def main():
    parser = argparse.ArgumentParser(description="Checks the rules of the house.")
    parser.add_argument("--root", default=pathlib.Path(__file__).resolve().parents[2])
    parser.add_argument("rules", nargs="*", metavar="RULE", help=", ".join(RULES))
    given = parser.parse_args()
    unknown = set(given.rules) - set(RULES)
    if unknown:
        parser.error("there is no rule %s" % ", ".join(sorted(unknown)))
    tree = Tree(given.root)
    complaints = [(rule, complaint) for rule in given.rules or RULES for complaint in RULES[rule](tree)]
    for rule, complaint in complaints:
        print("%s: %s" % (rule, complaint))
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
