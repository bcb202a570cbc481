// States of pixel transfers from and to memory.
#include "gl/state_access.h"
#include "gl/state_table.h"

namespace agaa::gl {
namespace {

using Gl = GladGLContext;

constexpr StateRow store(GLenum parameter, const char* name, const char* description, const char* layout = "i") {
    return {name, description, {parameter}, layout, readValues, setParameter<&Gl::PixelStorei>};
}

// clang-format off
constexpr StateRow kRows[] = {
    store(GL_PACK_SWAP_BYTES, "GL_PACK_SWAP_BYTES", "byte order, to memory", "b"),
    store(GL_PACK_LSB_FIRST, "GL_PACK_LSB_FIRST", "bit order, to memory", "b"),
    store(GL_PACK_ROW_LENGTH, "GL_PACK_ROW_LENGTH", "pixels a row, to memory"),
    store(GL_PACK_IMAGE_HEIGHT, "GL_PACK_IMAGE_HEIGHT", "rows a layer, to memory"),
    store(GL_PACK_SKIP_ROWS, "GL_PACK_SKIP_ROWS", "rows left out, to memory"),
    store(GL_PACK_SKIP_PIXELS, "GL_PACK_SKIP_PIXELS", "pixels left out, to memory"),
    store(GL_PACK_SKIP_IMAGES, "GL_PACK_SKIP_IMAGES", "layers left out, to memory"),
    store(GL_PACK_ALIGNMENT, "GL_PACK_ALIGNMENT", "alignment of rows, to memory"),
    store(GL_PACK_COMPRESSED_BLOCK_WIDTH, "GL_PACK_COMPRESSED_BLOCK_WIDTH",
          "block width, to memory"),
    store(GL_PACK_COMPRESSED_BLOCK_HEIGHT, "GL_PACK_COMPRESSED_BLOCK_HEIGHT",
          "block height, to memory"),
    store(GL_PACK_COMPRESSED_BLOCK_DEPTH, "GL_PACK_COMPRESSED_BLOCK_DEPTH",
          "block depth, to memory"),
    store(GL_PACK_COMPRESSED_BLOCK_SIZE, "GL_PACK_COMPRESSED_BLOCK_SIZE",
          "bytes a block, to memory"),
    store(GL_UNPACK_SWAP_BYTES, "GL_UNPACK_SWAP_BYTES", "byte order, from memory", "b"),
    store(GL_UNPACK_LSB_FIRST, "GL_UNPACK_LSB_FIRST", "bit order, from memory", "b"),
    store(GL_UNPACK_ROW_LENGTH, "GL_UNPACK_ROW_LENGTH", "pixels a row, from memory"),
    store(GL_UNPACK_IMAGE_HEIGHT, "GL_UNPACK_IMAGE_HEIGHT", "rows a layer, from memory"),
    store(GL_UNPACK_SKIP_ROWS, "GL_UNPACK_SKIP_ROWS", "rows left out, from memory"),
    store(GL_UNPACK_SKIP_PIXELS, "GL_UNPACK_SKIP_PIXELS", "pixels left out, from memory"),
    store(GL_UNPACK_SKIP_IMAGES, "GL_UNPACK_SKIP_IMAGES", "layers left out, from memory"),
    store(GL_UNPACK_ALIGNMENT, "GL_UNPACK_ALIGNMENT", "alignment of rows, from memory"),
    store(GL_UNPACK_COMPRESSED_BLOCK_WIDTH, "GL_UNPACK_COMPRESSED_BLOCK_WIDTH",
          "block width, from memory"),
    store(GL_UNPACK_COMPRESSED_BLOCK_HEIGHT, "GL_UNPACK_COMPRESSED_BLOCK_HEIGHT",
          "block height, from memory"),
    store(GL_UNPACK_COMPRESSED_BLOCK_DEPTH, "GL_UNPACK_COMPRESSED_BLOCK_DEPTH",
          "block depth, from memory"),
    store(GL_UNPACK_COMPRESSED_BLOCK_SIZE, "GL_UNPACK_COMPRESSED_BLOCK_SIZE",
          "bytes a block, from memory"),
    {"GL_CLAMP_READ_COLOR", "clamping of colours read", {GL_CLAMP_READ_COLOR}, "e", readValues,
     setParameter<&Gl::ClampColor>},
};
// clang-format on

} // namespace

std::span<const StateRow> pixelRows() { return kRows; }

} // namespace agaa::gl
