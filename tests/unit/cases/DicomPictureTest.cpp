#include "import/DicomPicture.h"

#include <gdcmFragment.h>
#include <gdcmImage.h>
#include <gdcmImageChangeTransferSyntax.h>
#include <gdcmSequenceOfFragments.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace insonate {
namespace {

using Syntax = gdcm::TransferSyntax;

constexpr std::array<unsigned, 3> kSize{20, 16, 3};
const gdcm::PixelFormat kFormat(1, 16, 16, 15, 0);
const gdcm::Tag kPixelTag(0x7fe0, 0x0010);

std::vector<std::string> pieces(const std::string& stream, std::size_t count) {
  const std::size_t each = stream.size() / count / 2 * 2;
  std::vector<std::string> list;
  for (std::size_t n = 0; n < count; ++n) list.push_back(stream.substr(n * each, n + 1 < count ? each : stream.npos));
  return list;
}

class Fragments : public testing::TestWithParam<Syntax::TSType> {
 protected:
  Fragments() {
    for (unsigned n = 0; n < kSize[0] * kSize[1] * kSize[2]; ++n) {
      const unsigned value = 1000 + 7 * n % 613 + n / 320;
      plain_.push_back(static_cast<char>(value & 0xff));
      plain_.push_back(static_cast<char>(value >> 8));
    }
    const gdcm::SmartPointer<gdcm::Image> image = new gdcm::Image;  // the filter counts its references
    image->SetNumberOfDimensions(3);
    image->SetDimensions(kSize.data());
    image->SetPixelFormat(kFormat);
    image->SetPhotometricInterpretation(gdcm::PhotometricInterpretation::MONOCHROME2);
    image->SetTransferSyntax(Syntax::ExplicitVRLittleEndian);
    gdcm::DataElement pixels(kPixelTag);
    pixels.SetByteValue(plain_.data(), gdcm::VL(static_cast<std::uint32_t>(plain_.size())));
    image->SetDataElement(pixels);
    gdcm::ImageChangeTransferSyntax change;
    change.SetTransferSyntax(GetParam());
    change.SetInput(*image);
    EXPECT_TRUE(change.Change());
    const auto* encoded = change.GetOutput().GetDataElement().GetSequenceOfFragments();
    for (unsigned f = 0; encoded && f < encoded->GetNumberOfFragments(); ++f) {
      const auto* bytes = encoded->GetFragment(f).GetByteValue();
      streams_.emplace_back(bytes->GetPointer(), bytes->GetLength());
      if (streams_.back().size() % 2) streams_.back() += '\0';
    }
  }

  /// Reads a file with these fragments and this offset table.
  std::optional<std::vector<char>> read(const std::vector<std::string>& fragments,
                                        const std::vector<std::uint32_t>& table = {}) const {
    auto sequence = gdcm::SequenceOfFragments::New();
    for (const std::string& one : fragments) {
      gdcm::Fragment fragment;
      fragment.SetByteValue(one.data(), gdcm::VL(static_cast<std::uint32_t>(one.size())));
      sequence->AddFragment(fragment);
    }
    std::string bytes(reinterpret_cast<const char*>(table.data()), 4 * table.size());
    bytes += tableBytes_;
    sequence->GetTable().SetByteValue(bytes.data(), gdcm::VL(static_cast<std::uint32_t>(bytes.size())));
    gdcm::DataElement pixels(kPixelTag, 0, gdcm::VR::OB);
    pixels.SetValue(*sequence);
    gdcm::File file;
    file.GetHeader().SetDataSetTransferSyntax(GetParam());
    file.GetDataSet().Insert(pixels);
    return storedPixels(file, kSize, kFormat);
  }

  std::vector<char> plain_;
  std::vector<std::string> streams_;
  std::string tableBytes_;
};

TEST_P(Fragments, OneForEachFrameNeedsNoOffsetTable) {
  ASSERT_EQ(streams_.size(), 3U);
  EXPECT_EQ(read(streams_), plain_);
}

TEST_P(Fragments, SeveralOfAFrameAreJoined) {
  ASSERT_EQ(streams_.size(), 3U);
  std::vector<std::string> fragments;
  std::vector<std::uint32_t> table;
  std::uint32_t place = 0;
  for (std::size_t f = 0; f < streams_.size(); ++f) {
    table.push_back(place);
    for (const std::string& piece : pieces(streams_[f], 1 + f)) {
      fragments.push_back(piece);
      place += 8 + static_cast<std::uint32_t>(piece.size());
    }
  }
  EXPECT_EQ(read(fragments), plain_) << "without an offset table";
  EXPECT_EQ(read(fragments, table), plain_) << "with an offset table";
  table[2] += 2;
  EXPECT_EQ(read(fragments, table), plain_) << "with a wrong offset table";
}

TEST_P(Fragments, MayBeShortAndLackTheOffsetTable) {
  ASSERT_EQ(streams_.size(), 3U);
  std::vector<std::string> fragments;
  for (const std::string& stream : streams_)
    for (const auto& [from, count] : {std::pair{0U, 4U}, {4U, 0U}, {4U, 2U}, {6U, 100000U}})
      fragments.push_back(stream.substr(from, count));
  EXPECT_EQ(read(fragments), plain_);
  // The item of the table is missing: GDCM then takes the first fragment for the table.
  tableBytes_ = fragments.front();
  fragments.erase(fragments.begin());
  EXPECT_EQ(read(fragments), plain_);
}

TEST_P(Fragments, ThatBelongToNoFrameAreRefused) {
  ASSERT_EQ(streams_.size(), 3U);
  const auto cut = pieces(streams_[1], 2);
  EXPECT_FALSE(read({streams_[0], streams_[1], streams_[2], streams_[2]}));
  EXPECT_FALSE(read({cut[1], streams_[0], streams_[1], streams_[2]}));
  EXPECT_FALSE(read({streams_[0], streams_[1]}));
}

std::string nameOfSyntax(const testing::TestParamInfo<Syntax::TSType>& shown) {
  std::string name = Syntax::GetTSString(shown.param);
  std::ranges::replace(name, '.', '_');
  return name;
}
INSTANTIATE_TEST_SUITE_P(, Fragments,
                         testing::Values(Syntax::JPEGLosslessProcess14, Syntax::JPEGLosslessProcess14_1,
                                         Syntax::JPEGLSLossless, Syntax::JPEG2000Lossless),
                         nameOfSyntax);

}  // namespace
}  // namespace insonate
