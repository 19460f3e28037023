#include "WholeFile.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

namespace insonate {
namespace fs = std::filesystem;
namespace {

struct MetaHeader {
  std::map<std::string, std::string> fields;
  std::vector<std::string> list;  ///< file names after "ElementDataFile = LIST"
  std::uint64_t end = 0;          ///< offset after the header

  std::string of(const std::string& key) const {
    const auto found = fields.find(key);
    return found == fields.end() ? std::string() : found->second;
  }
  bool isTrue(const std::string& key) const { return of(key).starts_with('T') || of(key).starts_with('t'); }
};

std::string trimmedText(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

/// Reads "Key = value" lines up to ElementDataFile, which is the last one.
MetaHeader readHeader(const fs::path& file) {
  MetaHeader header;
  std::ifstream in(file, std::ios::binary);
  constexpr int kMaxLines = 1000;
  std::string line;
  for (int n = 0; n < kMaxLines && std::getline(in, line); ++n) {
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos) continue;
    const std::string key = trimmedText(line.substr(0, equals));
    header.fields[key] = trimmedText(line.substr(equals + 1));
    if (key != "ElementDataFile") continue;
    header.end = static_cast<std::uint64_t>(in.tellg());
    if (!header.of(key).starts_with("LIST")) break;
    while (std::getline(in, line))
      if (!trimmedText(line).empty()) header.list.push_back(trimmedText(line));
  }
  return header;
}

/// Number of values written as text from `offset` on; the caller counts each with its binary size.
double wordsFrom(const fs::path& file, std::uint64_t offset) {
  std::ifstream in(file, std::ios::binary);
  in.seekg(static_cast<std::streamoff>(offset));
  return static_cast<double>(std::distance(std::istream_iterator<std::string>(in), {}));
}

std::uint64_t headerSizeOf(const MetaHeader& header) {
  try {
    const long long size = header.of("HeaderSize").empty() ? 0 : std::stoll(header.of("HeaderSize"));
    return size > 0 ? static_cast<std::uint64_t>(size) : 0;  // -1: the voxels are the end of the file
  } catch (const std::exception&) {
    return 0;
  }
}

double voxelsOf(const MetaHeader& header) {
  double count = 1;
  std::size_t start = 0;
  const std::string sizes = header.of("DimSize");
  while ((start = sizes.find_first_of("0123456789", start)) != std::string::npos) {
    const std::size_t end = std::min(sizes.find_first_not_of("0123456789", start), sizes.size());
    count *= std::stod(sizes.substr(start, end - start));
    start = end;
  }
  return count;
}

/// Voxels in one file.
HeldBytes heldBytes(const MetaHeader& header, const fs::path& file, std::uint64_t offset, double promised) {
  if (header.isTrue("CompressedData")) return inflatedBytes(file, offset);
  const bool text = !header.of("BinaryData").empty() && !header.isTrue("BinaryData");
  if (text) return {wordsFrom(file, offset) / std::max(voxelsOf(header), 1.0) * promised, false};
  return {bytesFrom(file, offset), false};
}

}  // namespace

Result<void> checkMetaImageHeader(const fs::path& file) {
  const std::string text = readHeader(file).of("NDims");
  int dimensions = 0;
  std::from_chars(text.data(), text.data() + text.size(), dimensions);
  constexpr int kMost = 10;  // limit of MetaIO
  if (dimensions >= 1 && dimensions <= kMost) return {};
  return fail("Could not read " + file.string() + ": its header says that it has '" + text +
              "' dimensions (NDims). It is damaged or no MetaImage; copy or export it again.");
}

Result<void> checkWholeMetaImage(const fs::path& file, double promised) {
  const MetaHeader header = readHeader(file);
  const std::string data = header.of("ElementDataFile");
  const std::string sorry = "Could not read " + file.string() + ": ";
  if (data == "LOCAL" || data == "Local" || data == "local")
    return checkHeld(file, promised, heldBytes(header, file, header.end, promised));
  if (data.find('%') != std::string::npos)
    return fail(sorry + "its voxels are in numbered files (" + data + "). Save it as one .mha file.");
  HeldBytes all;
  for (const std::string& name : header.list.empty() ? std::vector{data} : header.list) {
    const fs::path part = file.parent_path() / name;
    std::error_code error;
    if (!fs::is_regular_file(part, error))
      return fail(sorry + "there is no file " + part.string() +
                  ", which should contain its voxels. Copy this file, too.");
    const HeldBytes held = heldBytes(header, part, headerSizeOf(header), promised);
    all = {all.count + held.count, all.streamBreaks || held.streamBreaks};
  }
  return checkHeld(file, promised, all);
}

}  // namespace insonate
