#include "http/Ranges.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <string>

namespace insonate::web {
namespace {

/// A number that fills the whole text; empty otherwise.
std::optional<std::uint64_t> numberIn(std::string_view text) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

}  // namespace

std::optional<ByteRange> rangeOf(std::string_view header, std::uint64_t size) {
  constexpr std::string_view kBytes = "bytes=";
  const ByteRange whole{0, size};
  if (!header.starts_with(kBytes)) return whole;
  header.remove_prefix(kBytes.size());
  const std::size_t dash = header.find('-');
  if (dash == std::string_view::npos || header.find(',') != std::string_view::npos) return whole;
  const auto first = numberIn(header.substr(0, dash)), last = numberIn(header.substr(dash + 1));
  if (dash == 0) {
    if (!last) return whole;
    if (*last == 0 || size == 0) return std::nullopt;
    const std::uint64_t count = std::min(*last, size);
    return ByteRange{size - count, count};
  }
  if (!first || (!last && dash + 1 < header.size()) || (last && *last < *first)) return whole;
  if (*first >= size) return std::nullopt;
  return ByteRange{*first, (last ? std::min(*last, size - 1) : size - 1) - *first + 1};
}

Response sendFile(const Request& request, const std::filesystem::path& file, const std::string& type) {
  std::error_code error;
  const std::uint64_t size = std::filesystem::file_size(file, error);
  if (error) return {.status = 404, .type = "text/plain; charset=utf-8", .body = "The file is not here.\n"};
  const auto written = std::filesystem::last_write_time(file, error).time_since_epoch();
  const std::string tag = "\"" + std::to_string(size) + "-" + std::to_string(written.count()) + "\"";
  const std::string& condition = valueOf(request.headers, "if-range");
  const bool isSame = condition.empty() || condition == tag;
  const auto range = rangeOf(isSame ? valueOf(request.headers, "range") : "", size);
  Response response{.type = type, .headers = {{"Accept-Ranges", "bytes"}, {"ETag", tag}}};
  if (!range) {
    response.status = 416, response.body = "The file has no such part.\n", response.type = "text/plain; charset=utf-8";
    response.headers.emplace_back("Content-Range", "bytes */" + std::to_string(size));
    return response;
  }
  response.file = file, response.fileBegin = range->begin, response.fileSize = range->size;
  if (range->size == size) return response;
  response.status = 206;
  response.headers.emplace_back("Content-Range", "bytes " + std::to_string(range->begin) + "-" +
                                                     std::to_string(range->begin + range->size - 1) + "/" +
                                                     std::to_string(size));
  return response;
}

}  // namespace insonate::web
