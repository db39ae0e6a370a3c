#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes a small tree that keeps every rule of lint.py, breaks one rule at a time, and looks whether the lint says so."""
import pathlib
import tempfile
import unittest

import lint

MODULE_CMAKE = """set(SPHEREWALK_LAYER_0 base)
set(SPHEREWALK_LAYER_1 jpeg)
set(SPHEREWALK_LAYER_2 ui)
set(SPHEREWALK_LAYER_3 app)
set(SPHEREWALK_OWNER_Threads::Threads "base")
set(SPHEREWALK_OWNER_JPEG::JPEG "jpeg")
set(SPHEREWALK_OWNER_pybind11::module "app")
"""
OWNERS = """# Architecture

| third party | owner | for |
|---|---|---|
| libjpeg-turbo | jpeg | decoding |
| pybind11, NumPy (optional) | app/python | the Python module |
| CLI11 | app | the command lines |
"""
SUBJECT = "int subject(int value) {\n    return value;\n}\n" + "// a line of the subject\n" * 160


class BrokenTree(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.root = pathlib.Path(self.folder.name)
        self.write("packaging/cmake/SpherewalkModule.cmake", MODULE_CMAKE)
        self.write("resources/docs/architecture.md", OWNERS)
        self.write("README.md", "# A product\n")
        self.write("ui/CMakeLists.txt", "set(rooms look shell)\n")
        self.write("ui/look/CMakeLists.txt", "spherewalk_ui_room(\n  NAME look\n  SOURCES words.cpp\n  MODULES base)\n")
        self.write("ui/shell/CMakeLists.txt", "spherewalk_ui_room(\n  NAME shell\n  SOURCES window.cpp\n  ROOMS look # the ground\n  MODULES base)\n")
        self.write("ui/look/words.h", "")
        self.write("ui/shell/window.cpp", '#include "ui/look/words.h"\n' + SUBJECT)
        self.write("core/base/include/spherewalk/base/file.h", "")
        self.write("core/base/file.cpp", '#include "spherewalk/base/file.h"\n' + SUBJECT)
        self.write("core/jpeg/read/codec.cpp", '#include "read/codec.h"\n#include "spherewalk/base/file.h"\n' + SUBJECT)
        self.write("core/jpeg/read/codec.h", "")
        self.write("core/jpeg/show/region.cpp", '#include "read/codec.h"\n' + SUBJECT)
        self.write("core/jpeg/show/rows.cpp", '#include "read/codec.h"\n' + SUBJECT)

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def complaints(self):
        tree = lint.Tree(self.root)
        return {rule: found for rule, found in ((name, rule(tree)) for name, rule in lint.RULES.items()) if found}

    def expect(self, rule, *words):
        found = self.complaints()
        self.assertEqual(list(found), [rule], found)
        for word in words:
            self.assertIn(word, " ".join(found[rule]))

    def test_says_nothing_of_a_tree_that_keeps_all_rules(self):
        self.assertEqual(self.complaints(), {})

    def test_counts_the_sources_of_a_folder(self):
        for i in range(25):
            self.write("app/cli/part%d.cpp" % i, SUBJECT)
        self.expect("folder_size", "app/cli", "25")

    def test_leaves_generated_and_test_files_aside(self):
        for i in range(25):
            self.write("app/generated/part%d.cpp" % i, SUBJECT)
            self.write("tests/app/part%d.cpp" % i, SUBJECT)
        self.assertEqual(self.complaints(), {})

    def test_counts_the_lines_of_a_file(self):
        self.write("core/base/file.cpp", "// a line\n" * 450)
        self.assertEqual(self.complaints(), {})
        self.write("core/base/file.cpp", "// a line\n" * 451)
        self.expect("file_size", "core/base/file.cpp", "451")

    def test_finds_headers_with_one_user(self):
        for i in range(16):
            self.write("core/jpeg/read/part%d.h" % i, "")
        for i in range(5):
            self.write("core/jpeg/read/part%d.cpp" % i, '#include "read/part%d.h"\n' % i + SUBJECT)
        self.assertEqual(self.complaints(), {}) # the source of the same name is not a user
        for i in range(16):
            self.write("core/jpeg/show/user%d.cpp" % i, '#include "read/part%d.h"\n' % i + SUBJECT)
        self.expect("private_headers", "core/jpeg/read/part3.h", "core/jpeg/show/user3.cpp")

    def test_counts_users_through_every_way_to_spell_an_include(self):
        for i in range(16):
            self.write("core/jpeg/show/part%d.h" % i, "")
            self.write("core/jpeg/show/near%d.cpp" % i, '#include "part%d.h"\n' % i + SUBJECT)
        found = lint.headers_of_one(lint.Tree(self.root))
        self.assertEqual(found["core/jpeg/show/part0.h"], "core/jpeg/show/near0.cpp")
        for i in range(16):
            self.write("core/jpeg/read/inner%d.cpp" % i, '#  include "show/part%d.h"\n' % i + SUBJECT)
        self.assertEqual(lint.headers_of_one(lint.Tree(self.root)), {})

    def test_finds_cycles_between_rooms(self):
        self.write("core/jpeg/show/rows.h", "")
        self.write("core/jpeg/show/more.cpp", '#include "show/rows.h"\n' + SUBJECT)
        self.write("core/jpeg/read/codec.cpp", '#include "read/codec.h"\n#include "show/rows.h"\n' + SUBJECT)
        self.write("core/jpeg/show/third.cpp", '#include "show/rows.h"\n' + SUBJECT)
        self.expect("rooms", "read -> show -> read", "core/jpeg/read/codec.cpp includes core/jpeg/show/rows.h")

    def test_follows_public_headers_to_the_room_of_their_source(self):
        self.write("core/jpeg/include/spherewalk/jpeg/region.h", "")
        self.write("core/jpeg/read/codec.cpp", '#include "spherewalk/jpeg/region.h"\n' + SUBJECT)
        self.expect("rooms", "core/jpeg/include/spherewalk/jpeg/region.h")

    def test_finds_arrows_to_higher_layers(self):
        self.write("core/jpeg/include/spherewalk/jpeg/jpeg.h", "")
        self.write("core/base/file.cpp", '#include "spherewalk/jpeg/jpeg.h"\n' + SUBJECT)
        self.expect("layers", "core/base/file.cpp", "spherewalk/jpeg/jpeg.h")

    def test_finds_modules_without_a_layer(self):
        self.write("core/lens/glass.cpp", '#include "spherewalk/base/file.h"\n' + SUBJECT)
        self.expect("layers", "core/lens/glass.cpp", "no layer")

    def test_finds_rooms_of_the_window_that_are_not_linked(self):
        self.write("ui/shell/window.h", "")
        self.write("ui/look/words.cpp", '#include "ui/look/words.h"\n#include "ui/shell/window.h"\n' + SUBJECT)
        self.expect("ui_arrows", "ui/look/words.cpp", "ui/shell/window.h")

    def test_compares_the_table_of_owners_with_the_code(self):
        self.write("resources/docs/architecture.md", OWNERS.replace("| jpeg |", "| base, jpeg |"))
        self.expect("owners", "libjpeg-turbo", "base, jpeg")
        self.write("resources/docs/architecture.md", OWNERS.replace("| libjpeg-turbo | jpeg | decoding |\n", ""))
        self.expect("owners", "libjpeg-turbo", "not named")
        self.write("resources/docs/architecture.md", OWNERS + "| zlib | dataset | checksums |\n")
        self.expect("owners", "zlib")
        self.write("resources/docs/architecture.md", OWNERS)
        self.write("packaging/cmake/SpherewalkModule.cmake", MODULE_CMAKE + 'set(SPHEREWALK_OWNER_new::thing "base")\n')
        self.expect("owners", "new::thing")

    def test_measures_prose_but_no_tables_code_or_links(self):
        long = "word " * 30 + "\n"
        self.write("README.md", "| " + long + "```\n" + long + "```\n    " + long + "See https://example.org " + long)
        self.assertEqual(self.complaints(), {})
        self.write("resources/docs/deep/page.md", "# Page\n\n" + long)
        self.expect("prose", "resources/docs/deep/page.md:3", "150")

    def test_finds_sentences_that_a_language_lacks(self):
        message = "<message>\n<source>%s</source>\n<translation%s>x</translation>\n</message>\n"
        self.write("resources/translations/a_de.ts", message % ("Go", "") + message % ("Stop", ' type="unfinished"'))
        self.write("resources/translations/a_pl.ts", message % ("Go", ""))
        self.expect("translations", "a_de.ts", "translate", "Stop")
        self.expect("translations", "a_pl.ts", "lacks", "Stop")

    def test_finds_errors_that_the_window_cannot_translate(self):
        self.write("core/base/progress.cpp", 'throw Error(ErrorKind::Busy, text("The camera ", name, " sleeps. Wake it."));\n' + SUBJECT)
        self.write("ui/look/core_errors.cpp", 'QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "The camera %1 "\n"sleeps."),\n' + SUBJECT)
        self.expect("core_words", "core/base/progress.cpp:1", "Wake it.")

    def test_finds_steps_that_the_window_cannot_translate(self):
        self.write("core/align/solve.cpp", 'progress.progress(0.5, text("Solving photo ", i, " of ", n));\n' + SUBJECT)
        self.expect("core_words", "core/align/solve.cpp:1", "Solving photo %1 of %2")

    def test_finds_what_an_alignment_says_that_the_window_cannot_translate(self):
        self.write("core/align/solve/solve.cpp", 'pose.doubt = "It looks away. Turn it.";\n' + SUBJECT)
        self.expect("core_words", "core/align/solve/solve.cpp:1", "Turn it.")

    def test_counts_the_files_of_the_product(self):
        for i in range(860):
            self.write("core/base/room%d/part%d.cpp" % (i // 20, i), SUBJECT)
        self.expect("tree_size", "sources")

    def test_measures_the_median_source(self):
        for i in range(20):
            self.write("app/cli/part%d.cpp" % i, "// a line\n" * 159)
        self.expect("tree_size", "median", "159")

    def test_finds_functions_that_are_long_at_their_share(self):
        body = "    step();\n"
        ten = "void ten() {\n" + body * 8 + "}\n"
        self.write("core/base/file.cpp", ten * 30)
        self.expect("functions", "core/base/file.cpp", "10")

    def test_tells_functions_from_other_braces(self):
        text = """namespace a {
// void comment() {
struct Point {
    Point(int x, int y)
        : m_x{x}, m_y(y) {
        use("{");
    }
    int x() const { return m_x; }
    int m_x = 0;
};
constexpr std::array kNames{call(1), call(2)};
const auto table = std::map<int, int>({{1, 2}});
enum class Kind { One, Two };
#define MACRO(x) \\
    { x }
template <class T>
auto twice(const T& value) -> T {
    const auto inner = [&] {
        return value;
    };
    if (value) {
        return inner();
    }
    return value;
}
Point Point::operator=(const Point& other) = default;
bool Point::operator==(const Point& other) const {
    return true;
}
void last() {}
} // namespace a
"""
        self.assertEqual(lint.function_lengths(text), [(4, 4), (8, 1), (16, 10), (27, 3), (30, 1)])


if __name__ == "__main__":
    unittest.main()
