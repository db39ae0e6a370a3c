// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/bytes.h"

#include <jpeglib.h>

#include <array>
#include <csetjmp>
#include <cstdio> // jpeglib.h uses FILE and does not include it
#include <string>
#include <string_view>
#include <type_traits>

namespace spherewalk::jpeg {

/// Turns libjpeg's errors and warnings into Errors. libjpeg reports an error by a call that must not return.
/// The trap's function jumps back into guarded(), over C frames only, and guarded() throws.
class Trap {
  public:
    /// `tried` follows "Could not " in the sentence, for example "decode R0010001.JPG".
    explicit Trap(std::string tried);
    Trap(const Trap&) = delete;
    Trap& operator=(const Trap&) = delete;

    jpeg_error_mgr* manager() { return &m_manager; }

    jpeg_progress_mgr* scanLimit() { return &m_scanLimit; }

    /// Calls body(), which calls libjpeg. No object with a destructor may live between the body and libjpeg,
    /// because a jump skips it. Errors: Corrupt (also for warnings), Unsupported, Full for memory.
    template <class Body>
    void guarded(Body&& body) {
        using Plain = std::remove_reference_t<Body>;
        run([](void* call) { (*static_cast<Plain*>(call))(); },
            const_cast<void*>(static_cast<const void*>(&body)));
    }

    /// Leaves the guarded body with a message of our own. Range: only within guarded().
    [[noreturn]] void jump(const char* message);

  private:
    static void onError(j_common_ptr info);
    static void onMessage(j_common_ptr info, int level);
    static void onProgress(j_common_ptr info);

    void run(void (*call)(void*), void* body);
    [[noreturn]] void raise() const;

    jpeg_error_mgr m_manager{};
    jpeg_progress_mgr m_scanLimit{};
    std::jmp_buf m_jump{};
    std::array<char, JMSG_LENGTH_MAX> m_message{};
    std::string m_tried;
};

/// A libjpeg decompressor for bytes in memory, with its header read and checked. Owner: the bytes must
/// outlive it.
class Decompressor {
  public:
    enum class Keep { Nothing, AllMarkers };

    /// Errors: Corrupt; Unsupported for more than 2^28 pixels, CMYK, or arithmetic coding.
    Decompressor(ByteView jpeg, const std::string& tried, Keep keep = Keep::Nothing);
    ~Decompressor();
    Decompressor(const Decompressor&) = delete;
    Decompressor& operator=(const Decompressor&) = delete;

    jpeg_decompress_struct* get() { return &m_info; }

    Trap& trap() { return m_trap; }

  private:
    void open(ByteView jpeg, Keep keep);
    void check(ByteView jpeg, const std::string& tried) const;

    Trap m_trap;
    jpeg_decompress_struct m_info{};
};

/// A libjpeg compressor that writes into memory.
class Compressor {
  public:
    explicit Compressor(std::string tried);
    ~Compressor();
    Compressor(const Compressor&) = delete;
    Compressor& operator=(const Compressor&) = delete;

    jpeg_compress_struct* get() { return &m_info; }

    Trap& trap() { return m_trap; }

    /// The JPEG, which is complete after jpeg_finish_compress.
    Bytes& bytes() { return m_destination.bytes; }

  private:
    struct Destination {
        jpeg_destination_mgr manager{}; // first, so that libjpeg's pointer to it is a pointer to this
        Bytes bytes;
        std::array<std::uint8_t, 1 << 16> piece{};
    };

    static void begin(j_compress_ptr info);
    static boolean empty(j_compress_ptr info);
    static void end(j_compress_ptr info);
    static void append(j_compress_ptr info, std::size_t count);

    Trap m_trap;
    jpeg_compress_struct m_info{};
    Destination m_destination;
};

/// Writes a decompressor's coefficients and segments as a JPEG with optimised Huffman tables. to: with the
/// parameters of the other. mcusPerInterval: 0 for no restart markers. Range: within guarded() of both traps.
void writeCoefficients(jpeg_decompress_struct* from, jvirt_barray_ptr* coefficients, jpeg_compress_struct* to,
                       int mcusPerInterval);

} // namespace spherewalk::jpeg
