// SPDX-License-Identifier: Apache-2.0
#include "codec.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <jerror.h>

#include <algorithm>
#include <cstring>
#include <new>
#include <utility>

namespace spherewalk::jpeg {

namespace {

constexpr std::uint64_t kMaxPixels = 1ULL << 28;
// A progressive picture of a few kilobytes can make a decoder pass over all its pixels thousands of times.
constexpr int kMaxScans = 200;

ErrorKind kindOf(int code) {
    switch (code) {
    case JERR_OUT_OF_MEMORY:
        return ErrorKind::Full;
    case JERR_SOF_UNSUPPORTED:
    case JERR_BAD_PRECISION:
    case JERR_COMPONENT_COUNT:
    case JERR_CONVERSION_NOTIMPL:
    case JERR_CCIR601_NOTIMPL:
    case JERR_FRACT_SAMPLE_NOTIMPL:
    case JERR_IMAGE_TOO_BIG:
    case JERR_MISMATCHED_QUANT_TABLE:
        return ErrorKind::Unsupported;
    default:
        return ErrorKind::Corrupt;
    }
}

std::string_view adviceFor(ErrorKind kind) {
    switch (kind) {
    case ErrorKind::Full:
        return "close other programs or use smaller pictures";
    case ErrorKind::Unsupported:
        return "save it as an ordinary baseline JPEG";
    default:
        return "the file is damaged, fetch or copy it again";
    }
}

Trap& trapOf(j_common_ptr info) {
    return *static_cast<Trap*>(info->client_data);
}

} // namespace

Trap::Trap(std::string tried) : m_tried(std::move(tried)) {
    jpeg_std_error(&m_manager);
    m_manager.error_exit = onError;
    m_manager.emit_message = onMessage;
    m_scanLimit.progress_monitor = onProgress;
}

void Trap::onError(j_common_ptr info) {
    Trap& trap = trapOf(info);
    info->err->format_message(info, trap.m_message.data());
    std::longjmp(trap.m_jump, 1);
}

void Trap::onMessage(j_common_ptr info, int level) {
    // Below 0 are warnings: libjpeg would go on with grey or garbled blocks.
    if (level < 0) {
        onError(info);
    }
}

void Trap::onProgress(j_common_ptr info) {
    if (info->is_decompressor && reinterpret_cast<j_decompress_ptr>(info)->input_scan_number > kMaxScans) {
        trapOf(info).jump("it has an unreasonable number of scans");
    }
}

void Trap::jump(const char* message) {
    std::strncpy(m_message.data(), message, m_message.size() - 1);
    m_manager.msg_code = 0;
    std::longjmp(m_jump, 1);
}

void Trap::run(void (*call)(void*), void* body) {
    if (setjmp(m_jump) == 0) {
        call(body);
        return;
    }
    raise();
}

void Trap::raise() const {
    const ErrorKind kind = kindOf(m_manager.msg_code);
    throw Error(kind, text("Could not ", m_tried, ": ", adviceFor(kind), " (",
                           printable(m_message.data(), m_message.size()), ")."));
}

Decompressor::Decompressor(ByteView jpeg, const std::string& tried, Keep keep) : m_trap(tried) {
    m_info.err = m_trap.manager();
    m_info.client_data = &m_trap;
    try {
        m_trap.guarded([&] { open(jpeg, keep); });
        check(jpeg, tried);
    } catch (const Error&) {
        jpeg_destroy_decompress(&m_info);
        throw;
    }
}

Decompressor::~Decompressor() {
    jpeg_destroy_decompress(&m_info);
}

void Decompressor::open(ByteView jpeg, Keep keep) {
    jpeg_create_decompress(&m_info);
    m_info.progress = m_trap.scanLimit();
    jpeg_mem_src(&m_info, jpeg.data(), jpeg.size());
    if (keep == Keep::AllMarkers) {
        for (int marker = JPEG_APP0; marker <= JPEG_APP0 + 15; ++marker) {
            jpeg_save_markers(&m_info, marker, 0xFFFF);
        }
        jpeg_save_markers(&m_info, JPEG_COM, 0xFFFF);
    }
    jpeg_read_header(&m_info, TRUE);
}

void Decompressor::check(ByteView jpeg, const std::string& tried) const {
    const std::uint64_t pixels = std::uint64_t{m_info.image_width} * m_info.image_height;
    const bool isColour = m_info.num_components == 3;
    if (pixels > kMaxPixels) {
        throw Error(ErrorKind::Unsupported,
                    text("Could not ", tried, ": it has ", m_info.image_width, " x ", m_info.image_height,
                         " pixels, more than this version takes; reduce it."));
    }
    if (m_info.num_components == 4) {
        throw Error(ErrorKind::Unsupported,
                    text("Could not ", tried, ": it is CMYK, as for printing; save it as an RGB JPEG."));
    }
    if ((m_info.num_components != 1 && !isColour) || m_info.arith_code) {
        throw Error(ErrorKind::Unsupported,
                    text("Could not ", tried,
                         ": it is neither grey nor RGB, or is arithmetic-coded; save it as an ordinary "
                         "baseline JPEG."));
    }
    // Every block of 64 pixels takes a bit at least: a small file cannot make us reserve gigabytes.
    if (jpeg.size() < pixels / 512) {
        throw Error(ErrorKind::Corrupt, text("Could not ", tried, ": its ", humanBytes(jpeg.size()),
                                             " cannot hold ", m_info.image_width, " x ", m_info.image_height,
                                             " pixels; the file is damaged, fetch or copy it again."));
    }
}

Compressor::Compressor(std::string tried) : m_trap(std::move(tried)) {
    m_info.err = m_trap.manager();
    m_info.client_data = &m_trap;
    m_trap.guarded([&] { jpeg_create_compress(&m_info); });
    m_destination.manager.init_destination = begin;
    m_destination.manager.empty_output_buffer = empty;
    m_destination.manager.term_destination = end;
    m_info.dest = &m_destination.manager;
}

Compressor::~Compressor() {
    jpeg_destroy_compress(&m_info);
}

void Compressor::begin(j_compress_ptr info) {
    auto& destination = *reinterpret_cast<Destination*>(info->dest);
    destination.manager.next_output_byte = destination.piece.data();
    destination.manager.free_in_buffer = destination.piece.size();
}

boolean Compressor::empty(j_compress_ptr info) {
    // The rule of libjpeg: all of the buffer counts, whatever free_in_buffer says.
    append(info, reinterpret_cast<Destination*>(info->dest)->piece.size());
    begin(info);
    return TRUE;
}

void Compressor::end(j_compress_ptr info) {
    const auto& destination = *reinterpret_cast<Destination*>(info->dest);
    append(info, destination.piece.size() - destination.manager.free_in_buffer);
}

void Compressor::append(j_compress_ptr info, std::size_t count) {
    auto& destination = *reinterpret_cast<Destination*>(info->dest);
    bool isOutOfMemory = false;
    try {
        destination.bytes.insert(destination.bytes.end(), destination.piece.begin(),
                                 destination.piece.begin() + static_cast<std::ptrdiff_t>(count));
    } catch (const std::bad_alloc&) {
        isOutOfMemory = true; // an exception must not pass through libjpeg's frames
    }
    if (isOutOfMemory) {
        ERREXIT1(info, JERR_OUT_OF_MEMORY, 0);
    }
}

void writeCoefficients(jpeg_decompress_struct* from, jvirt_barray_ptr* coefficients, jpeg_compress_struct* to,
                       int mcusPerInterval) {
    jpeg_copy_critical_parameters(from, to);
    // The source's own segments are written below, as they are; libjpeg must add none.
    to->write_JFIF_header = FALSE;
    to->write_Adobe_marker = FALSE;
    to->restart_interval = static_cast<unsigned>(mcusPerInterval);
    to->restart_in_rows = 0;
    to->optimize_coding = TRUE;
    jpeg_write_coefficients(to, coefficients);
    for (jpeg_saved_marker_ptr marker = from->marker_list; marker != nullptr; marker = marker->next) {
        jpeg_write_marker(to, marker->marker, marker->data, marker->data_length);
    }
    jpeg_finish_compress(to);
    jpeg_finish_decompress(from);
}

} // namespace spherewalk::jpeg
