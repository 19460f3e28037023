#pragma once

#include <gdcmDataSet.h>

#include <optional>
#include <string>
#include <vector>

namespace insonate {

/// Returns an element's text without padding; empty if the element is absent.
std::string textOf(const gdcm::DataSet& data, gdcm::Tag tag);
/// Returns an element's text as one line of UTF-8; letters of character sets other than Latin-1 and UTF-8 become "?".
std::string lineOf(const gdcm::DataSet& data, gdcm::Tag tag);
/// Returns the numbers of a decimal or integer string; empty if absent or malformed.
std::vector<double> numbersOf(const gdcm::DataSet& data, gdcm::Tag tag);
std::optional<double> numberOf(const gdcm::DataSet& data, gdcm::Tag tag);
std::optional<int> integerOf(const gdcm::DataSet& data, gdcm::Tag tag);
/// Returns a 16-bit binary value (VR US or SS) as unsigned; the caller applies the sign.
std::optional<unsigned> shortOf(const gdcm::DataSet& data, gdcm::Tag tag);
/// Returns the items of a sequence; empty if absent.
std::vector<gdcm::DataSet> itemsOf(const gdcm::DataSet& data, gdcm::Tag tag);

}  // namespace insonate
