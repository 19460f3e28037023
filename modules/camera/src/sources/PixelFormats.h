#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace insonate::camera {

/// Copies the gray values of an image in YUYV format (two bytes for each pixel, rows of `stride` bytes) to `gray`.
/// Returns false if the bytes are too few.
bool grayFromYuyv(std::span<const std::uint8_t> bytes, int width, int height, std::size_t stride,
                  std::vector<std::uint8_t>& gray);
/// The same for one byte for each pixel.
bool grayFromGray(std::span<const std::uint8_t> bytes, int width, int height, std::size_t stride,
                  std::vector<std::uint8_t>& gray);
/// Decodes the gray values of a JPEG image, of a camera that sends MJPEG. Returns false if the image is damaged or has
/// another size.
bool grayFromJpeg(std::span<const std::uint8_t> bytes, int width, int height, std::vector<std::uint8_t>& gray);

}  // namespace insonate::camera
