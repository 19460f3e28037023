#pragma once

#include <gdcmDataSet.h>

#include <optional>
#include <string>
#include <vector>

namespace insonate {

/// Text without padding; empty when the element is absent.
std::string textOf(const gdcm::DataSet& data, gdcm::Tag tag);
/// The numbers of a decimal or integer string; empty when absent or malformed.
std::vector<double> numbersOf(const gdcm::DataSet& data, gdcm::Tag tag);
std::optional<double> numberOf(const gdcm::DataSet& data, gdcm::Tag tag);
std::optional<int> integerOf(const gdcm::DataSet& data, gdcm::Tag tag);
/// A 16-bit binary value (VR US or SS), sign not yet applied.
std::optional<unsigned> shortOf(const gdcm::DataSet& data, gdcm::Tag tag);
/// The items of a sequence; empty when absent.
std::vector<gdcm::DataSet> itemsOf(const gdcm::DataSet& data, gdcm::Tag tag);

}  // namespace insonate
