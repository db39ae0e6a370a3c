// SPDX-License-Identifier: Apache-2.0
// The installed library, used by programs that know nothing of the source tree.
#include "program.h"
#include "temporary_folder.h"
#include "test_dataset.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <sstream>

namespace spherewalk::render {

namespace {

struct Outcome {
    int status = 0;
    std::string output; ///< and errors
};

std::string quoted(const std::filesystem::path& path) {
    return "'" + path.string() + "'";
}

Outcome shell(const std::string& command) {
    test::Program program({"/bin/sh", "-c", command});
    const int status = program.wait();
    return {status, program.output() + program.errors()};
}

/// Its output.
std::string done(const std::string& command) {
    const Outcome outcome = shell(command);
    EXPECT_EQ(outcome.status, 0) << command << '\n' << outcome.output;
    return outcome.output;
}

} // namespace

/// The library, installed for one place and moved to another, both with a space in their names. Only pkgconf,
/// which counts from 1, finds packages in such a folder.
class Install : public testing::Test {
  public:
    Install() {
        const std::filesystem::path staged = m_folder / "staged";
        for (const std::string component : {"render", "render_library"}) {
            done("DESTDIR=" + quoted(staged) + " " SPHEREWALK_CMAKE " --install " + quoted(SPHEREWALK_BUILD) +
                 " --component " + component + " --prefix '/opt/sphere walk'");
        }
        std::filesystem::rename(staged / "opt/sphere walk", prefix);
        for (const auto& entry : std::filesystem::recursive_directory_iterator(prefix)) {
            if (entry.path().extension() == ".pc") {
                packages = entry.path().parent_path();
            }
        }
        Eigen::Quaterniond turned(0.9, 0.1, -0.2, 0.3);
        turned.normalize();
        test::writeTestDataset(dataset, {{turned, {1, 2, 3}}}, test::smoothWorld, 512, 2.0);
    }

    std::string configuring(const std::filesystem::path& source, const std::filesystem::path& build) const {
        return "PKG_CONFIG_PATH=" + quoted(packages) +
               " " SPHEREWALK_CMAKE " -G '" SPHEREWALK_GENERATOR "' -DCMAKE_C_COMPILER=" SPHEREWALK_C_COMPILER
               " -DCMAKE_CXX_COMPILER=" SPHEREWALK_CXX_COMPILER " -DCMAKE_PREFIX_PATH=" +
               quoted(prefix) + " -S " + quoted(source) + " -B " + quoted(build);
    }

    /// The folder in which the project was built.
    std::filesystem::path built(const std::filesystem::path& source, const std::string& name) const {
        std::filesystem::path build = m_folder / ("build " + name);
        done(configuring(source, build));
        done(SPHEREWALK_CMAKE " --build " + quoted(build));
        return build;
    }

    /// What the program prints; the picture is written to this name beside the dataset.
    std::string run(const std::filesystem::path& program, const std::string& picture) const {
        return done(quoted(program) + " " + quoted(dataset) + " " + quoted(this->picture(picture)));
    }

    std::filesystem::path picture(const std::string& name) const { return m_folder / name; }

    std::filesystem::path example(const std::string& language) const {
        return prefix / "share/doc/spherewalk_render/examples" / language;
    }

    /// A folder with these files.
    std::filesystem::path project(const std::string& lists, const std::string& source = {}) const {
        std::filesystem::path folder = m_folder / "project";
        std::filesystem::create_directories(folder);
        writeFile(folder / "CMakeLists.txt", bytesOf(lists));
        writeFile(folder / "main.cpp", bytesOf(source));
        return folder;
    }

  private:
    test::TemporaryFolder m_folder;

  public:
    std::filesystem::path prefix =
        m_folder / (shell("pkg-config --version").output.starts_with("0.") ? "moved" : "moved here");
    std::filesystem::path dataset = m_folder / "the dataset";
    std::filesystem::path packages; ///< where the .pc files are
};

TEST_F(Install, NamesNoPlaceOfTheMachineThatBuiltIt) {
    int read = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(prefix)) {
        const auto& file = entry.path();
        if (file.extension() == ".cmake" || file.extension() == ".pc") {
            const std::string text = readTextFile(file);
            for (const char* place : {SPHEREWALK_SOURCE, SPHEREWALK_BUILD, "/opt", "staged"}) {
                EXPECT_THAT(text, testing::Not(testing::HasSubstr(place))) << file;
            }
            ++read;
        }
    }
    EXPECT_EQ(read, 10);
    EXPECT_TRUE(std::filesystem::exists(prefix / "share/doc/spherewalk_render/Apache-2.0.txt"));
    EXPECT_TRUE(std::filesystem::exists(prefix / "share/doc/spherewalk_render/render-api.md"));
}

TEST_F(Install, ExamplesInCAndCppRenderTheSamePicture) {
    const std::string cpp = run(built(example("cpp"), "cpp") / "render_view", "cpp.ppm");
    const std::string c = run(built(example("c"), "c") / "render_view", "c.ppm");
    EXPECT_THAT(cpp,
                testing::StartsWith("From photos/0.jpg, 0.1 m away, with the scene model sphere: trust 0."));
    const std::string untilTimes = cpp.substr(0, cpp.find(", decoded"));
    EXPECT_EQ(c.substr(0, untilTimes.size()), untilTimes);
    const Bytes picture = readFile(this->picture("cpp.ppm"));
    EXPECT_EQ(picture.size(), 15U + 3 * 640 * 480);
    EXPECT_GT(std::set(picture.begin(), picture.end()).size(), 50U); // no blank one
    EXPECT_EQ(readFile(this->picture("c.ppm")), picture);
}

TEST_F(Install, CProgramsLinkWithTheArchivesAndWithoutPkgConfig) {
    const std::filesystem::path source = example("c") / "render_view.c";
    for (const std::string option : {"", "--static"}) {
        const std::filesystem::path program = picture("archives" + option);
        done("export PKG_CONFIG_PATH=" + quoted(packages) +
             "; eval \"" SPHEREWALK_C_COMPILER " -std=c99 -Wall -Wextra -Werror -pedantic -o " +
             quoted(program) + " " + quoted(source) + " $(pkg-config " + option +
             " --cflags --libs spherewalk_render)\"");
        run(program, "archives" + option + ".ppm");
    }
    const auto folder = project("cmake_minimum_required(VERSION 3.16)\nproject(c LANGUAGES C)\n"
                                "find_package(spherewalk_c 0.1 REQUIRED)\nadd_executable(view \"" +
                                source.string() + "\")\ntarget_link_libraries(view spherewalk::c)\n");
    run(built(folder, "found") / "view", "found.ppm");
    EXPECT_EQ(readFile(picture("archives.ppm")), readFile(picture("found.ppm")));
    EXPECT_EQ(readFile(picture("archives--static.ppm")), readFile(picture("found.ppm")));
}

TEST_F(Install, TheSharedLibraryExportsTheCInterfaceAlone) {
    const std::string header = readTextFile(prefix / "include/spherewalk/spherewalk.h") +
                               readTextFile(prefix / "include/spherewalk/sensor.h") +
                               readTextFile(prefix / "include/spherewalk/light.h");
    std::istringstream lines(done(SPHEREWALK_NM " -D --defined-only -f posix " +
                                  quoted(packages.parent_path() / "libspherewalk_c.so")));
    int functions = 0;
    for (std::string line; std::getline(lines, line);) {
        const std::string symbol = line.substr(0, line.find_first_of(" @"));
        if (symbol != "SPHEREWALK_0") { // the version of all symbols
            EXPECT_THAT(header, testing::HasSubstr(" " + symbol + "(")) << line;
            ++functions;
        }
    }
    int declared = 0;
    for (std::size_t at = header.find("\nSPHEREWALK_API"); at != std::string::npos;
         at = header.find("\nSPHEREWALK_API", at + 1)) {
        ++declared;
    }
    EXPECT_EQ(functions, declared);
}

// It would crash; with -march=native the same happens.
TEST_F(Install, ProgramsInWhichEigenAlignsOtherwiseDoNotCompile) {
    const Outcome outcome = shell(
        "export PKG_CONFIG_PATH=" + quoted(packages) +
        "; eval \"" SPHEREWALK_CXX_COMPILER " -std=c++20 -fsyntax-only -DEIGEN_MAX_STATIC_ALIGN_BYTES=0 " +
        quoted(example("cpp") / "render_view.cpp") + " $(pkg-config --cflags spherewalk_render)\"");
    EXPECT_NE(outcome.status, 0);
    EXPECT_THAT(outcome.output, testing::HasSubstr("compiled for other instructions"));
}

TEST_F(Install, TheDocumentsCodeIsThatOfTheExamples) {
    std::string compiled;
    for (const std::string file :
         {"cpp/CMakeLists.txt", "cpp/render_view.cpp", "c/CMakeLists.txt", "c/render_view.c"}) {
        compiled += readTextFile(example(file));
    }
    std::istringstream document(readTextFile(prefix / "share/doc/spherewalk_render/render-api.md"));
    std::string block;
    bool isCode = false;
    int blocks = 0;
    for (std::string line; std::getline(document, line);) {
        if (line.starts_with("```")) {
            if (isCode) {
                EXPECT_THAT(compiled, testing::HasSubstr(block));
                ++blocks;
            }
            isCode = !isCode;
            block.clear();
        } else if (isCode) {
            block += line + '\n';
        }
    }
    EXPECT_EQ(blocks, 6);
}

TEST_F(Install, OtherVersionsAreNotFound) {
    for (const std::string package : {"spherewalk_render 0.2", "spherewalk_render 1.0", "spherewalk_c 1.0"}) {
        const auto folder =
            project("cmake_minimum_required(VERSION 3.16)\nproject(v LANGUAGES NONE)\nfind_package(" +
                    package + " REQUIRED)\n");
        const Outcome outcome = shell(configuring(folder, picture("versions")));
        EXPECT_NE(outcome.status, 0) << package;
        EXPECT_THAT(outcome.output, testing::HasSubstr("version: 0.1.0")) << package;
    }
}

} // namespace spherewalk::render
