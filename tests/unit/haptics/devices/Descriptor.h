#pragma once

#include <cstdint>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace insonate::test {

/// The bytes of resources/haptics/insonate-descriptor.hex; # begins a comment.
inline std::vector<std::uint8_t> insonateDescriptor() {
  std::ifstream file(INSONATE_DESCRIPTOR);
  std::vector<std::uint8_t> bytes;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    for (std::string word; words >> word;) bytes.push_back(static_cast<std::uint8_t>(std::stoi(word, nullptr, 16)));
  }
  return bytes;
}

/// Fields of one kind that follow each other in a report.
struct DescribedField {
  std::uint32_t usagePage = 0;
  int bit = 0, bits = 0, count = 0;
  bool isSigned = false;
};

/// Contents of a HID report descriptor (Device Class Definition 1.11, section 6.2.2): only the items that lay out
/// bits. By report id; input and output apart.
struct DescribedReports {
  std::map<int, std::vector<DescribedField>> input, output;
  std::uint32_t usagePage = 0, usage = 0;  ///< of the application collection
  int openCollections = 0;
  bool whole = true;  ///< no item reaches beyond the end
};

inline DescribedReports parseDescriptor(const std::vector<std::uint8_t>& bytes) {
  DescribedReports result;
  std::uint32_t page = 0, usage = 0, size = 0, count = 0;
  std::int64_t least = 0;
  int id = 0;
  std::map<std::pair<bool, int>, int> used;
  for (std::size_t i = 0; i < bytes.size();) {
    const std::uint8_t head = bytes[i++];
    const std::size_t length = (head & 3) == 3 ? 4 : head & 3;
    if (i + length > bytes.size()) result.whole = false;
    std::uint32_t value = 0;
    for (std::size_t k = 0; k < length && i + k < bytes.size(); ++k) value |= std::uint32_t{bytes[i + k]} << (8 * k);
    i += length;
    const auto signExtended = [&] {
      const int unused = static_cast<int>(32 - 8 * length);
      return length == 0 ? 0 : static_cast<std::int32_t>(value << unused) >> unused;
    };
    switch (head & 0xFC) {
      case 0x04:
        page = value;
        break;
      case 0x08:
        usage = value;
        break;
      case 0x14:
        least = signExtended();
        break;
      case 0x74:
        size = value;
        break;
      case 0x94:
        count = value;
        break;
      case 0x84:
        id = static_cast<int>(value);
        break;
      case 0xA0:
        if (result.openCollections++ == 0) result.usagePage = page, result.usage = usage;
        break;
      case 0xC0:
        --result.openCollections;
        break;
      case 0x80:
      case 0x90: {
        const bool in = (head & 0xFC) == 0x80;
        int& bit = used[{in, id}];
        (in ? result.input : result.output)[id].push_back(
            {page, bit, static_cast<int>(size), static_cast<int>(count), least < 0});
        bit += static_cast<int>(size * count);
        break;
      }
      default:
        break;
    }
  }
  return result;
}

}  // namespace insonate::test
