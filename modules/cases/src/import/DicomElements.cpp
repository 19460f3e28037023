#include "DicomElements.h"

#include <insonate/tissue/OwnLabels.h>

#include <gdcmByteValue.h>
#include <gdcmSequenceOfItems.h>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace insonate {
namespace {

std::string_view trimmed(std::string_view text) {
  const std::string_view padding(" \0\t\r\n", 5);
  const std::size_t first = text.find_first_not_of(padding);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(padding) - first + 1);
}

std::optional<double> parsed(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace

std::string textOf(const gdcm::DataSet& data, gdcm::Tag tag) {
  if (!data.FindDataElement(tag)) return {};
  const gdcm::ByteValue* bytes = data.GetDataElement(tag).GetByteValue();
  if (!bytes || !bytes->GetPointer()) return {};
  return std::string(trimmed({bytes->GetPointer(), bytes->GetLength()}));
}

std::string lineOf(const gdcm::DataSet& data, gdcm::Tag tag) {
  const std::string characterSet = textOf(data, gdcm::Tag(0x0008, 0x0005));
  const bool isUtf8 = characterSet.starts_with("ISO_IR 192"), isLatin1 = characterSet.starts_with("ISO_IR 100");
  std::string line;
  for (const char letter : textOf(data, tag)) {
    const auto c = static_cast<unsigned char>(letter);
    if (c < 0x20 || c == 0x7F)
      line += ' ';
    else if (c < 0x80 || isUtf8)
      line += letter;
    else if (isLatin1)
      line += {static_cast<char>(0xC0 | (c >> 6)), static_cast<char>(0x80 | (c & 0x3F))};
    else
      line += '?';
  }
  return tidyLabelName(line);
}

std::vector<double> numbersOf(const gdcm::DataSet& data, gdcm::Tag tag) {
  const std::string text = textOf(data, tag);
  std::vector<double> numbers;
  for (std::size_t start = 0; !text.empty() && start <= text.size();) {
    const std::size_t end = std::min(text.find('\\', start), text.size());
    const auto value = parsed(std::string_view(text).substr(start, end - start));
    if (!value) return {};
    numbers.push_back(*value);
    start = end + 1;
  }
  return numbers;
}

std::optional<double> numberOf(const gdcm::DataSet& data, gdcm::Tag tag) {
  const auto numbers = numbersOf(data, tag);
  return numbers.empty() ? std::nullopt : std::optional(numbers.front());
}

std::optional<int> integerOf(const gdcm::DataSet& data, gdcm::Tag tag) {
  const auto number = numberOf(data, tag);
  if (!number || std::abs(*number) > 2e9) return std::nullopt;
  return static_cast<int>(*number);
}

std::optional<unsigned> shortOf(const gdcm::DataSet& data, gdcm::Tag tag) {
  if (!data.FindDataElement(tag)) return std::nullopt;
  const gdcm::ByteValue* bytes = data.GetDataElement(tag).GetByteValue();
  if (!bytes || !bytes->GetPointer() || bytes->GetLength() < 2) return std::nullopt;
  std::uint16_t value = 0;
  std::memcpy(&value, bytes->GetPointer(), sizeof value);
  return value;
}

std::vector<gdcm::DataSet> itemsOf(const gdcm::DataSet& data, gdcm::Tag tag) {
  if (!data.FindDataElement(tag)) return {};
  const auto sequence = data.GetDataElement(tag).GetValueAsSQ();
  if (!sequence) return {};
  std::vector<gdcm::DataSet> items;
  for (std::size_t n = 1; n <= sequence->GetNumberOfItems(); ++n)
    items.push_back(sequence->GetItem(n).GetNestedDataSet());
  return items;
}

}  // namespace insonate
