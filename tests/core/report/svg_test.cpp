// SPDX-License-Identifier: GPL-3.0-or-later
#include "markup.h"
#include "random.h"

#include "spherewalk/report/svg.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace spherewalk::report {

namespace {

std::size_t countOf(const std::string& all, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = 0; (at = all.find(part, at)) != std::string::npos; at += part.size()) {
        ++found;
    }
    return found;
}

/// What one call adds to an empty drawing.
template <class Draw>
std::string drawn(const Draw& draw) {
    Svg svg(100, 80, "t");
    const std::string before = svg.str();
    draw(svg);
    const std::string end = "</svg>\n";
    const std::string after = svg.str();
    EXPECT_TRUE(after.starts_with(before.substr(0, before.size() - end.size())));
    EXPECT_TRUE(after.ends_with(end));
    return after.substr(before.size() - end.size(), after.size() - before.size());
}

} // namespace

TEST(Svg, BoxesOverlapOnlyWhereTheyShareAnArea) {
    const SvgBox box{10, 10, 20, 10};
    EXPECT_TRUE(box.overlaps({29, 19, 5, 5}));
    EXPECT_FALSE(box.overlaps({30, 10, 5, 5}));
    EXPECT_FALSE(box.overlaps({10, 20, 5, 5}));
    EXPECT_TRUE(box.overlaps({0, 0, 100, 100}));
}

TEST(Svg, SaysItsSizeAndItsTitle) {
    const std::string svg = Svg(640, 480, "A <b> & \"c\"").str();
    EXPECT_TRUE(svg.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"640\" height=\"480\""));
    EXPECT_EQ(countOf(svg, "viewBox=\"0 0 640 480\""), 1U);
    EXPECT_EQ(countOf(svg, "<title>A &lt;b&gt; &amp; &quot;c&quot;</title>"), 1U);
    EXPECT_EQ(countOf(svg, "prefers-color-scheme: dark"), 1U);
}

TEST(Svg, DrawsEachShapeWhereItIsAsked) {
    EXPECT_EQ(drawn([](Svg& svg) {
                  svg.line({1, 2}, {3, 4.5}, Svg::Line::Axis);
              }),
              "<line class=\"axis\" x1=\"1.0\" y1=\"2.0\" x2=\"3.0\" y2=\"4.5\"/>\n");
    EXPECT_EQ(drawn([](Svg& svg) {
                  svg.line({1, 2}, {3, 4}, Svg::Line::Mark, "#123456");
              }),
              "<line class=\"mark\" x1=\"1.0\" y1=\"2.0\" x2=\"3.0\" y2=\"4.0\" stroke=\"#123456\"/>\n");
    EXPECT_EQ(drawn([](Svg& svg) {
                  svg.rectangle({1, 2, 30, 40}, "red");
              }),
              "<rect x=\"1.0\" y=\"2.0\" width=\"30.0\" height=\"40.0\" fill=\"red\"/>\n");
    EXPECT_EQ(drawn([](Svg& svg) {
                  svg.circle({5, 6}, 7, "red");
              }),
              "<circle cx=\"5.0\" cy=\"6.0\" r=\"7.0\" fill=\"red\"/>\n");
}

TEST(Svg, DrawsPolygonsWithAndWithoutFillingAndEdge) {
    const std::vector<SvgPoint> corners{{0, 0}, {10, 0}, {0, 10}};
    EXPECT_EQ(drawn([&](Svg& svg) { svg.polygon(corners, ""); }),
              "<polygon points=\"0.0,0.0 10.0,0.0 0.0,10.0\" fill=\"none\"/>\n");
    EXPECT_EQ(drawn([&](Svg& svg) { svg.polygon(corners, "blue", Svg::Line::Grid); }),
              "<polygon class=\"grid\" points=\"0.0,0.0 10.0,0.0 0.0,10.0\" fill=\"blue\"/>\n");
    EXPECT_EQ(drawn([&](Svg& svg) { svg.path(corners, Svg::Line::Dashed); }),
              "<polyline class=\"dashed\" points=\"0.0,0.0 10.0,0.0 0.0,10.0\" fill=\"none\"/>\n");
}

TEST(Svg, EscapesWordsAndTurnsThemUpwards) {
    EXPECT_EQ(drawn([](Svg& svg) {
                  svg.text({10, 20}, "a < b", Svg::Text::Small);
              }),
              "<text class=\"small\" x=\"10.0\" y=\"20.0\" text-anchor=\"start\">a &lt; b</text>\n");
    const std::string turned = drawn([](Svg& svg) {
        svg.text({10, 20}, "up", Svg::Text::Label, SvgAnchor::End, true);
    });
    EXPECT_EQ(countOf(turned, "text-anchor=\"end\""), 1U);
    EXPECT_EQ(countOf(turned, "transform=\"rotate(-90 10.0 20.0)\""), 1U);
}

TEST(Svg, LongerWordsInLargerLettersCoverMore) {
    const SvgBox word = Svg::extent({10, 50}, "word", Svg::Text::Small);
    EXPECT_EQ(word.x, 10);
    EXPECT_LT(word.y, 50);               // above the base line
    EXPECT_GT(word.y + word.height, 50); // and a little below
    EXPECT_DOUBLE_EQ(Svg::extent({10, 50}, "wordword", Svg::Text::Small).width, 2 * word.width);
    EXPECT_GT(Svg::extent({10, 50}, "word", Svg::Text::Title).width, word.width);
}

TEST(Svg, IsWellFormedWhateverItsWordsAre) {
    test::Random random(9);
    SCOPED_TRACE(random.seed());
    const std::string letters = "<>&\"'/= ax";
    for (int i = 0; i < 100; ++i) {
        std::string words(static_cast<std::size_t>(random.integer(0, 12)), ' ');
        for (char& letter : words) {
            letter =
                letters[static_cast<std::size_t>(random.integer(0, static_cast<int>(letters.size()) - 1))];
        }
        Svg svg(100, 80, words);
        svg.text({1, 2}, words, Svg::Text::Label, SvgAnchor::Middle, i % 2 == 0);
        svg.circle({5, 6}, 7, "red");
        EXPECT_EQ(test::markupDefect(svg.str()), "") << words;
    }
}

TEST(Escaped, CanBeReadBack) {
    const std::string words = "a < b && \"c\" > d; &lt; & &amp;quot;";
    std::string read = escaped(words);
    for (const auto& [entity, letter] :
         {std::pair("&lt;", "<"), {"&gt;", ">"}, {"&quot;", "\""}, {"&amp;", "&"}}) {
        for (std::size_t at = 0; (at = read.find(entity, at)) != std::string::npos; ++at) {
            read.replace(at, std::string(entity).size(), letter);
        }
    }
    EXPECT_EQ(read, words);
}

TEST(Escaped, LeavesNothingThatXmlGivesAMeaning) {
    EXPECT_EQ(escaped("<a href=\"x\">&amp;</a>"), "&lt;a href=&quot;x&quot;&gt;&amp;amp;&lt;/a&gt;");
    EXPECT_EQ(escaped("Küche 2"), "Küche 2");
}

} // namespace spherewalk::report
