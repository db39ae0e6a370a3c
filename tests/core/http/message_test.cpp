// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/text.h"
#include "spherewalk/http/message.h"

#include <gtest/gtest.h>

namespace spherewalk::http {

TEST(HttpRequestHead, IsTakenApart) {
    const auto request = parseRequestHead("POST /files/a%20b?type=thumb&empty&x=%41%zz HTTP/1.1\r\n"
                                          "Host: camera:8080\r\n"
                                          "content-type:  text/plain \r\n"
                                          "X-Empty:\r\n"
                                          "Host: another");
    ASSERT_TRUE(request);
    EXPECT_EQ(request->method, "POST");
    EXPECT_EQ(request->target, "/files/a%20b?type=thumb&empty&x=%41%zz");
    EXPECT_EQ(request->path, "/files/a b");
    EXPECT_EQ(request->query.at("type"), "thumb");
    EXPECT_EQ(request->query.at("empty"), "");
    EXPECT_EQ(request->query.at("x"), "A%zz");
    EXPECT_EQ(request->header("HOST"), "camera:8080") << "the first counts, whatever the letters";
    EXPECT_EQ(request->header("Content-Type"), "text/plain");
    EXPECT_EQ(request->header("X-Empty"), "");
    EXPECT_EQ(request->header("Missing"), "");
}

TEST(HttpRequestHead, SaysWhetherTheConnectionStays) {
    const auto stays = [](const std::string& version, const std::string& header) {
        return parseRequestHead(text("GET / ", version, header)).value().keepsAlive;
    };
    EXPECT_TRUE(stays("HTTP/1.1", ""));
    EXPECT_TRUE(stays("HTTP/1.1", "\r\nConnection: keep-alive"));
    EXPECT_FALSE(stays("HTTP/1.1", "\r\nConnection: Close"));
    EXPECT_FALSE(stays("HTTP/1.0", ""));
    EXPECT_TRUE(stays("HTTP/1.0", "\r\nConnection: Keep-Alive"));
}

TEST(HttpRequestHead, IsRefusedWhereItIsNone) {
    for (const char* wrong :
         {"", "GET", "GET /", "GET / HTTP/2.0", "get / HTTP/1.1", "GET  / HTTP/1.1", "GET / HTTP/1.1 x",
          " / HTTP/1.1", "GET / HTTP/1.1\r\nno colon", "GET / HTTP/1.1\r\n: no name",
          "GET / HTTP/1.1\r\nbad name: x", "\x16\x03\x01\x02", "GET /\nHTTP/1.1"}) {
        EXPECT_FALSE(parseRequestHead(wrong)) << wrong;
    }
}

TEST(HttpRequestBody, HasTheLengthThatItsHeadAnnounces) {
    const auto length = [](const std::string& header) {
        return contentLength(parseRequestHead("POST / HTTP/1.1" + header).value());
    };
    EXPECT_EQ(length(""), 0U);
    EXPECT_EQ(length("\r\ncontent-length: 12"), 12U);
    for (const char* wrong : {"-1", "+1", "0x10", "1 2", "12a", "99999999999999999999999"}) {
        EXPECT_FALSE(length(std::string("\r\nContent-Length: ") + wrong)) << wrong;
    }
}

} // namespace spherewalk::http
