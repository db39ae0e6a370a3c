// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/program.h"

#include "spherewalk/base/text.h"

#include <exception>

namespace spherewalk::program {

namespace {

int fail(const Error& error, const std::function<void(const Error&)>& onError) {
    if (onError) {
        onError(error);
    }
    printLine(stderr, error.sentence());
    if (!error.context().empty()) {
        printLine(stderr, text("  (", error.context(), ")"));
    }
    return error.kind() == ErrorKind::Stopped ? kStopped : kFailed;
}

} // namespace

void printLine(std::FILE* stream, const std::string& line) {
    std::fputs((line + "\n").c_str(), stream);
}

int guarded(const std::function<int()>& body, const std::function<void(const Error&)>& onError) {
    try {
        return body();
    } catch (const Error& error) {
        return fail(error, onError);
    } catch (const std::exception& defect) { // whatever no module translated
        return fail(
            Error(ErrorKind::Internal, text("Spherewalk met a defect of its own: ", defect.what(), ".")),
            onError);
    }
}

} // namespace spherewalk::program
