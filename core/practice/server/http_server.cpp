// SPDX-License-Identifier: GPL-3.0-or-later
#include "server/http_server.h"

#include "spherewalk/base/text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <unistd.h>

namespace spherewalk::practice {

namespace {

constexpr std::chrono::milliseconds kTransferTimeout(20'000);
constexpr std::chrono::milliseconds kStopGlance(20); ///< How often a wait looks whether to stop.
constexpr std::size_t kMaxHead = 64 * 1024;
constexpr std::size_t kConnections = 32; ///< A connection that is kept alive holds its thread.

char lowered(char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

bool isSameWord(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](char x, char y) { return lowered(x) == lowered(y); });
}

std::string_view withoutBlanks(std::string_view words) {
    const std::size_t begin = words.find_first_not_of(" \t");
    return begin == std::string_view::npos ? std::string_view()
                                           : words.substr(begin, words.find_last_not_of(" \t") + 1 - begin);
}

/// Cuts off the part before the separator, or all where there is none.
std::string_view cutUntil(std::string_view& words, std::string_view separator) {
    const std::size_t end = std::min(words.find(separator), words.size());
    const std::string_view part = words.substr(0, end);
    words.remove_prefix(std::min(end + separator.size(), words.size()));
    return part;
}

/// The text that a part of a URL spells. A percent sign without two digits stands for itself.
std::string unescaped(std::string_view part) {
    std::string spelled;
    for (std::size_t i = 0; i < part.size(); ++i) {
        unsigned byte = 0;
        const char* const digits = part.data() + i + 1;
        if (part[i] == '%' && i + 2 < part.size() &&
            std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2) {
            spelled += static_cast<char>(byte);
            i += 2;
        } else {
            spelled += part[i];
        }
    }
    return spelled;
}

std::string_view reasonOf(int status) {
    switch (status) {
    case 200:
        return "OK";
    case 400:
        return "Bad Request";
    case 401:
        return "Unauthorized";
    case 403:
        return "Forbidden";
    case 404:
        return "Not Found";
    case 405:
        return "Method Not Allowed";
    case 411:
        return "Length Required";
    case 413:
        return "Payload Too Large";
    case 431:
        return "Request Header Fields Too Large";
    case 503:
        return "Service Unavailable";
    default:
        return "Internal Server Error";
    }
}

/// Nothing for a length that is no number. Source: RFC 9110, 8.6.
std::optional<std::size_t> lengthIn(const std::string& spelled) {
    std::size_t length = 0;
    const char* const end = spelled.data() + spelled.size();
    const auto [stop, failure] = std::from_chars(spelled.data(), end, length);
    return failure == std::errc() && stop == end ? std::optional(length) : std::nullopt;
}

} // namespace

bool HeaderOrder::operator()(const std::string& a, const std::string& b) const {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(),
                                        [](char x, char y) { return lowered(x) < lowered(y); });
}

std::string HttpRequest::header(const std::string& name) const {
    const auto found = headers.find(name);
    return found == headers.end() ? std::string() : found->second;
}

std::optional<HttpRequest> parseRequestHead(std::string_view head) {
    std::string_view line = cutUntil(head, "\r\n");
    HttpRequest request;
    request.method = cutUntil(line, " ");
    request.target = cutUntil(line, " ");
    const bool isMethod = !request.method.empty() && std::all_of(request.method.begin(), request.method.end(),
                                                                 [](char c) { return c >= 'A' && c <= 'Z'; });
    if (!isMethod || request.target.empty() || (line != "HTTP/1.1" && line != "HTTP/1.0")) {
        return std::nullopt;
    }
    const bool isOld = line == "HTTP/1.0";
    std::string_view query = request.target;
    request.path = unescaped(cutUntil(query, "?"));
    while (!query.empty()) {
        std::string_view value = cutUntil(query, "&");
        const std::string key = unescaped(cutUntil(value, "="));
        request.query.emplace(key, unescaped(value));
    }
    while (!head.empty()) {
        line = cutUntil(head, "\r\n");
        const std::size_t colon = line.find(':');
        if (colon == 0 || colon == std::string_view::npos ||
            line.substr(0, colon).find(' ') != std::string_view::npos) {
            return std::nullopt;
        }
        request.headers.emplace(line.substr(0, colon), withoutBlanks(line.substr(colon + 1)));
    }
    const std::string connection = request.header("Connection");
    request.keepsAlive = isOld ? isSameWord(connection, "keep-alive") : !isSameWord(connection, "close");
    return request;
}

HttpConnection::HttpConnection(int socket, const std::atomic<bool>& isSilent)
    : m_socket(socket), m_isSilent(isSilent) {
    const int on = 1;
    ::setsockopt(m_socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
}

HttpConnection::~HttpConnection() {
    ::shutdown(m_socket, SHUT_RDWR);
    ::close(m_socket);
}

bool HttpConnection::await(short events, std::chrono::milliseconds timeout) const {
    const auto end = std::chrono::steady_clock::now() + timeout;
    while (isOpen() && std::chrono::steady_clock::now() < end) {
        pollfd waiting{m_socket, events, 0};
        const int ready = ::poll(&waiting, 1, static_cast<int>(kStopGlance.count()));
        if (ready > 0) {
            return true;
        }
        if (ready < 0 && errno != EINTR) {
            return false;
        }
    }
    return false;
}

bool HttpConnection::receive(std::chrono::milliseconds timeout) {
    std::array<char, 16 * 1024> bytes; // NOLINT(*-member-init): filled below
    const ssize_t count = await(POLLIN, timeout) ? ::recv(m_socket, bytes.data(), bytes.size(), 0) : -1;
    if (count <= 0) {
        drop();
        return false;
    }
    m_received.append(bytes.data(), static_cast<std::size_t>(count));
    return true;
}

void HttpConnection::refuse(int status) {
    m_isLast = true;
    answer({status, "text/plain", ""});
    drop();
}

std::optional<HttpRequest> HttpConnection::nextHead(std::chrono::milliseconds timeout) {
    if (m_isLast || !isOpen() || (m_received.empty() && !receive(timeout))) {
        return std::nullopt;
    }
    m_isHead = false;
    std::size_t end = 0;
    while ((end = m_received.find("\r\n\r\n")) == std::string::npos && m_received.size() <= kMaxHead) {
        if (!receive(kTransferTimeout)) {
            return std::nullopt;
        }
    }
    std::optional<HttpRequest> request;
    if (end <= kMaxHead) {
        request = parseRequestHead(std::string_view(m_received).substr(0, end));
    }
    if (!request) {
        refuse(end <= kMaxHead ? 400 : 431);
        return std::nullopt;
    }
    m_received.erase(0, end + 4);
    m_isHead = request->method == "HEAD";
    m_isLast = !request->keepsAlive;
    return request;
}

bool HttpConnection::readBody(HttpRequest& request, std::size_t maxBytes) {
    const bool isChunked = request.headers.contains("Transfer-Encoding");
    const std::string spelled = request.header("Content-Length");
    const std::optional<std::size_t> length = spelled.empty() ? 0 : lengthIn(spelled);
    if (isChunked || !length || *length > maxBytes) {
        refuse(isChunked ? 411 : length ? 413 : 400);
        return false;
    }
    if (isSameWord(request.header("Expect"), "100-continue")) {
        send("HTTP/1.1 100 Continue\r\n\r\n");
    }
    while (m_received.size() < *length) {
        if (!receive(kTransferTimeout)) {
            return false;
        }
    }
    request.body = m_received.substr(0, *length);
    m_received.erase(0, *length);
    return true;
}

bool HttpConnection::send(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t wrote = await(POLLOUT, kTransferTimeout)
                                  ? ::send(m_socket, bytes.data(), bytes.size(), MSG_NOSIGNAL)
                                  : -1;
        if (wrote <= 0) {
            drop();
            return false;
        }
        bytes.remove_prefix(static_cast<std::size_t>(wrote));
    }
    return isOpen();
}

void HttpConnection::sendHead(int status, const std::vector<std::pair<std::string, std::string>>& headers) {
    std::string head = text("HTTP/1.1 ", status, " ", reasonOf(status), "\r\n");
    for (const auto& [name, value] : headers) {
        head += text(name, ": ", value, "\r\n");
    }
    head += m_isLast ? "Connection: close\r\n\r\n" : "Keep-Alive: timeout=60\r\n\r\n";
    send(head);
}

void HttpConnection::answer(const HttpAnswer& answer) {
    auto headers = answer.headers;
    if (!answer.type.empty()) {
        headers.emplace_back("Content-Type", answer.type);
    }
    headers.emplace_back("Content-Length", text(answer.body.size()));
    sendHead(answer.status, headers);
    send(m_isHead ? std::string_view() : answer.body);
}

void HttpConnection::beginAnswer(const std::string& type, std::size_t bytes) {
    sendHead(
        200,
        {{"X-Content-Type-Options", "nosniff"}, {"Content-Type", type}, {"Content-Length", text(bytes)}});
}

void HttpConnection::beginChunks(const std::string& type) {
    sendHead(
        200,
        {{"X-Content-Type-Options", "nosniff"}, {"Content-Type", type}, {"Transfer-Encoding", "chunked"}});
}

bool HttpConnection::sendChunk(ByteView bytes) {
    std::array<char, 16> digits{};
    const char* const end = std::to_chars(digits.data(), digits.data() + digits.size(), bytes.size(), 16).ptr;
    return send(text(std::string_view(digits.data(), static_cast<std::size_t>(end - digits.data())), "\r\n",
                     std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()), "\r\n"));
}

void HttpConnection::awaitLeaving() const {
    while (isOpen()) {
        pollfd waiting{m_socket, POLLRDHUP, 0};
        const int ready = ::poll(&waiting, 1, static_cast<int>(kStopGlance.count()));
        if (ready > 0 || (ready < 0 && errno != EINTR)) {
            return;
        }
    }
}

HttpServer::~HttpServer() {
    close();
    if (m_holder >= 0) {
        ::close(m_holder);
    }
}

namespace {

/// A socket that is bound to the address; -1 if it cannot be had. Both the holding and the listening socket
/// must allow the other, and a second camera on the port must be refused: hence SO_REUSEADDR and not
/// SO_REUSEPORT.
int boundSocket(const sockaddr* address, socklen_t bytes) {
    const int made = ::socket(address->sa_family, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const int on = 1;
    if (made >= 0 && ::setsockopt(made, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on) == 0 &&
        ::bind(made, address, bytes) == 0) {
        return made;
    }
    if (made >= 0) {
        ::close(made);
    }
    return -1;
}

} // namespace

int HttpServer::hold(const std::string& host, int port) {
    addrinfo wanted{};
    wanted.ai_family = AF_UNSPEC;
    wanted.ai_socktype = SOCK_STREAM;
    wanted.ai_flags = AI_PASSIVE | AI_NUMERICSERV;
    addrinfo* found = nullptr;
    if (::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &wanted, &found) != 0) {
        return 0;
    }
    m_holder = boundSocket(found->ai_addr, found->ai_addrlen);
    ::freeaddrinfo(found);
    auto* const address = reinterpret_cast<sockaddr*>(&m_address);
    m_addressBytes = sizeof m_address;
    std::array<char, NI_MAXSERV> service{};
    if (m_holder < 0 || ::getsockname(m_holder, address, &m_addressBytes) != 0 ||
        ::getnameinfo(address, m_addressBytes, nullptr, 0, service.data(), service.size(), NI_NUMERICSERV) !=
            0) {
        return 0;
    }
    return static_cast<int>(parseNumber(service.data()).value_or(0));
}

bool HttpServer::open() {
    m_listening = boundSocket(reinterpret_cast<const sockaddr*>(&m_address), m_addressBytes);
    if (m_listening < 0 || ::listen(m_listening, SOMAXCONN) != 0) {
        close();
        return false;
    }
    m_isSilent = false;
    for (std::size_t i = 0; i < kConnections; ++i) {
        m_threads.emplace_back([this] { acceptAndServe(); });
    }
    return true;
}

void HttpServer::acceptAndServe() {
    while (!m_isSilent) {
        const int socket = ::accept4(m_listening, nullptr, nullptr, SOCK_CLOEXEC);
        if (socket >= 0) {
            HttpConnection connection(socket, m_isSilent);
            m_serve(connection);
        } else if (errno != EINTR && errno != ECONNABORTED) {
            constexpr std::chrono::milliseconds kRelief(5); // no descriptor is free, or the port was closed
            std::this_thread::sleep_for(kRelief);
        }
    }
}

void HttpServer::close() {
    m_isSilent = true;
    if (m_listening >= 0) {
        ::shutdown(m_listening, SHUT_RDWR); // ends accept4 in all threads
        m_threads.clear();
        ::close(m_listening);
        m_listening = -1;
    }
}

} // namespace spherewalk::practice
