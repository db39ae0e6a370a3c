// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"

#include "spherewalk/camera/endpoint.h"

namespace spherewalk::camera {
namespace {

using test::expectError;

TEST(Endpoint, ReadsWhatAnOperatorTypes) {
    EXPECT_EQ(parseEndpoint("192.168.1.1"), (Endpoint{"192.168.1.1", 80}));
    EXPECT_EQ(parseEndpoint("http://127.0.0.1:8080/"), (Endpoint{"127.0.0.1", 8080}));
    EXPECT_EQ(parseEndpoint("THETAYL00123456.local:80"), (Endpoint{"THETAYL00123456.local", 80}));
    EXPECT_EQ(parseEndpoint("[fe80::1%eth0]:81"), (Endpoint{"fe80::1%eth0", 81}));
}

TEST(Endpoint, ReadsItsOwnName) {
    for (const char* address : {"192.168.1.1", "a.local:99", "[::1]:8080"}) {
        const Endpoint endpoint = parseEndpoint(address);
        EXPECT_EQ(parseEndpoint(endpoint.name()), endpoint);
        EXPECT_EQ(parseEndpoint(endpoint.url("/")), endpoint);
    }
}

TEST(Endpoint, RefusesAnythingElse) {
    for (const char* address : {"", ":80", "host:", "host:0", "host:65536", "host:8o", "https://host", "a b",
                                "user@host", "host/path", "[::1", "[::1]80", "http://", "::1", "a\nb"}) {
        expectError(ErrorKind::InvalidInput, "cannot be used", [&] { parseEndpoint(address); });
    }
}

TEST(FileUrl, KeepsOnlyThePath) {
    EXPECT_EQ(pathOfUrl("http://192.168.1.1/files/a/R1.JPG"), "/files/a/R1.JPG");
    EXPECT_EQ(pathOfUrl("https://other:99/R1.JPG?type=thumb#x"), "/R1.JPG?type=thumb");
    EXPECT_EQ(pathOfUrl("/files/R1.JPG"), "/files/R1.JPG");
}

TEST(FileUrl, RefusesWhatIsNone) {
    for (const std::string& url :
         {std::string(), std::string("http://"), std::string("http://host"), std::string("http://host/"),
          std::string("http://host/a b"), std::string("http://host/a\r\nX: y"), std::string(3000, '/')}) {
        expectError(ErrorKind::Corrupt, "not a usable URL", [&] { pathOfUrl(url); });
    }
    expectError(ErrorKind::Unsupported, "API level 1", [] { pathOfUrl("100RICOH/R0010001.JPG"); });
}

TEST(FileUrl, GivesANameThatIsSafeAnywhere) {
    EXPECT_EQ(fileNameOfUrl("http://h/files/100RICOH/R0010049.JPG?type=thumb"), "R0010049.JPG");
    EXPECT_EQ(fileNameOfUrl("http://h/a/.."), "_..");
    EXPECT_EQ(fileNameOfUrl("http://h/a/%2e%2e%2fx"), "_2e_2e_2fx");
    EXPECT_EQ(fileNameOfUrl("http://h/a/b\\c:d"), "b_c_d");
    EXPECT_EQ(fileNameOfUrl("http://h/folder/"), "_");
}

} // namespace
} // namespace spherewalk::camera
