// SPDX-License-Identifier: GPL-3.0-or-later
#include "fault_script.h"

#include <array>
#include <string>

namespace spherewalk::campaign {

using practice::Fault;
using practice::FaultKind;

namespace {

template <class T, std::size_t n>
const T& oneOf(test::Random& random, const std::array<T, n>& choices) {
    return choices[static_cast<std::size_t>(random.integer(0, static_cast<int>(n) - 1))];
}

const std::array<std::string, 10> kCalls{"/osc/info",          "/osc/state",           "camera.getOptions",
                                         "camera.setOptions",  "camera.listFiles",     "camera.takePicture",
                                         "camera.takePicture", "/osc/commands/status", "/files",
                                         "/practice/none"};
const std::array<std::string, 9> kMoments{"/osc/info",
                                          "/osc/state",
                                          "camera.getOptions",
                                          "camera.listFiles",
                                          "camera.takePicture",
                                          "camera.takePicture",
                                          "/osc/commands/status",
                                          "exposing",
                                          "written"};
const std::array<std::string, 16> kCodes{"unknownCommand",
                                         "disabledCommand",
                                         "missingParameter",
                                         "invalidParameterName",
                                         "tooManyParameters",
                                         "corruptedFile",
                                         "powerOffSequenceRunning",
                                         "invalidFileFormat",
                                         "serviceUnavailable",
                                         "unexpected",
                                         "canceledShooting",
                                         "invalidParameterValue",
                                         "deviceBusy",
                                         "noFreeSpace",
                                         "serverError",
                                         "invalidSessionId"};

bool isOfPreview(FaultKind kind) {
    return kind == FaultKind::PreviewWithoutBoundary || kind == FaultKind::PreviewWrongLength ||
           kind == FaultKind::PreviewStall;
}

/// Where a fault of this kind can happen.
std::string callOf(test::Random& random, FaultKind kind) {
    if (kind >= FaultKind::RefuseConnections) {
        return oneOf(random, kMoments);
    }
    if (kind >= FaultKind::MissingFile) {
        return "/files";
    }
    if (kind >= FaultKind::EmptyPhoto) {
        return "camera.takePicture";
    }
    if (kind >= FaultKind::ForgetIds) {
        return "/osc/commands/status";
    }
    if (kind == FaultKind::DropAfterHeader) {
        return random.integer(0, 1) == 0 ? "/osc/commands/execute" : "/osc/commands/status";
    }
    return oneOf(random, kCalls);
}

double amountOf(test::Random& random, FaultKind kind) {
    switch (kind) {
    case FaultKind::RefuseConnections:
    case FaultKind::Sleep:
    case FaultKind::Reboot:
        return random.uniform(1, 20);
    case FaultKind::Battery:
        return random.uniform(0.05, 1);
    case FaultKind::Slow:
        return random.uniform(2, 6);
    default:
        return 0;
    }
}

FaultKind randomKind(test::Random& random) {
    for (;;) {
        const auto kind =
            static_cast<FaultKind>(random.integer(0, static_cast<int>(FaultKind::NoMoreTrouble)));
        // A request that is never answered costs 20 s; some of those are enough.
        const bool isSlow = kind == FaultKind::NeverAnswer || kind == FaultKind::StallDownload;
        if (!isOfPreview(kind) && (!isSlow || random.integer(0, 3) == 0)) {
            return kind;
        }
    }
}

} // namespace

practice::PracticeCameraOptions randomCamera(test::Random& random, const std::filesystem::path& folder) {
    using practice::CameraModel;
    using WhenBusy = practice::PracticeCameraOptions::WhenBusy;
    practice::PracticeCameraOptions options;
    options.width = 1024;
    options.isPlain = true;
    options.seed = random.seed();
    options.storageFolder = folder / "camera";
    options.truthFile = folder / "truth.jsonl";
    options.model = oneOf(random, std::array{CameraModel::ThetaV, CameraModel::ThetaV, CameraModel::ThetaV,
                                             CameraModel::ThetaS, CameraModel::LevelOne});
    options.whenBusy = oneOf(
        random, std::array{WhenBusy::DisabledCommand, WhenBusy::ServiceUnavailable, WhenBusy::DeviceBusy});
    options.doneAnswers = random.integer(0, 2);
    options.urlsOfAccessPoint = random.integer(0, 1) == 0;
    if (random.integer(0, 3) == 0) {
        options.digestUser = kUser;
        options.digestPassword = kPassword;
        options.nonceRequests = random.integer(0, 30);
    }
    return options;
}

std::vector<Fault> randomScript(test::Random& random) {
    std::vector<Fault> script;
    const int count = random.integer(1, 6);
    for (int i = 0; i < count; ++i) {
        Fault fault;
        fault.kind = randomKind(random);
        fault.on = callOf(random, fault.kind);
        fault.skip = random.integer(0, fault.on == "camera.takePicture" ? 4 : 12);
        fault.count = random.integer(0, 3) == 0 ? random.integer(2, 4) : 1;
        fault.byte = static_cast<std::uint64_t>(random.integer(0, 8000));
        if (fault.kind == FaultKind::CorruptDownload) {
            fault.byte += 20'000; // behind the metadata: nobody can see what is wrong there
        }
        fault.amount = amountOf(random, fault.kind);
        if (fault.kind == FaultKind::Refuse) {
            fault.code = oneOf(random, kCodes);
        }
        script.push_back(fault);
    }
    return script;
}

} // namespace spherewalk::campaign
