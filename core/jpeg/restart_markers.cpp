// SPDX-License-Identifier: Apache-2.0
#include "codec.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jpeg/restart.h"

#include <utility>

namespace spherewalk::jpeg {

namespace {

void transcode(jpeg_decompress_struct* from, jpeg_compress_struct* to, int mcusPerInterval) {
    jvirt_barray_ptr* coefficients = jpeg_read_coefficients(from);
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

} // namespace

Bytes withRestartMarkers(ByteView jpeg, int mcusPerInterval, std::string_view source) {
    if (mcusPerInterval < 1 || mcusPerInterval > 65535) {
        throw Error(
            ErrorKind::InvalidInput,
            text("Restart markers can stand every 1 to 65535 MCUs, not every ", mcusPerInterval, "."));
    }
    const std::string tried = text("add restart markers to ", source);
    Decompressor decompressor(jpeg, tried, Decompressor::Keep::AllMarkers);
    Compressor compressor(tried);
    // Both report into one trap: a jump has one place to land in.
    compressor.get()->err = decompressor.trap().manager();
    compressor.get()->client_data = &decompressor.trap();
    decompressor.trap().guarded([&] { transcode(decompressor.get(), compressor.get(), mcusPerInterval); });
    return std::move(compressor.bytes());
}

} // namespace spherewalk::jpeg
