#include "DicomPicture.h"

#include <gdcmBitmap.h>
#include <gdcmByteValue.h>
#include <gdcmSequenceOfFragments.h>

namespace insonate {

std::optional<std::vector<char>> storedPixels(const gdcm::File& file, const std::array<unsigned, 3>& size,
                                              const gdcm::PixelFormat& format) {
  const gdcm::Tag pixelData(0x7fe0, 0x0010);
  const gdcm::DataSet& data = file.GetDataSet();
  if (!data.FindDataElement(pixelData)) return std::nullopt;
  const gdcm::DataElement& pixels = data.GetDataElement(pixelData);
  const std::size_t needed = std::size_t{size[0]} * size[1] * size[2] * (format.GetBitsAllocated() / 8);
  // GDCM fills what is missing.
  const gdcm::ByteValue* plain = pixels.GetByteValue();
  const gdcm::SequenceOfFragments* fragments = pixels.GetSequenceOfFragments();
  if (plain ? plain->GetLength() < needed : !fragments || fragments->GetNumberOfFragments() == 0) return std::nullopt;
  const gdcm::TransferSyntax syntax = file.GetHeader().GetDataSetTransferSyntax();
  gdcm::Bitmap picture;
  // All fragments belong to a picture that is the only one.
  picture.SetNumberOfDimensions(size[2] > 1 ? 3 : 2);
  picture.SetDimensions(size.data());
  picture.SetPixelFormat(format);
  picture.SetPhotometricInterpretation(gdcm::PhotometricInterpretation::MONOCHROME2);
  picture.SetTransferSyntax(syntax);
  picture.SetNeedByteSwap(syntax == gdcm::TransferSyntax::ImplicitVRBigEndianPrivateGE);
  picture.SetDataElement(pixels);
  if (picture.GetBufferLength() != needed) return std::nullopt;
  std::vector<char> bytes(needed);
  if (!picture.GetBuffer(bytes.data())) return std::nullopt;
  return bytes;
}

}  // namespace insonate
