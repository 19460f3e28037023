#include "DicomEncoding.h"

#include <insonate/cases/DicomWriter.h>
#include <insonate/core/AtomicFile.h>

#include <gdcmAttribute.h>
#include <gdcmTrace.h>
#include <gdcmWriter.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <sstream>
#include <utility>

namespace insonate {
namespace fs = std::filesystem;
namespace {

using gdcm::Tag;
using gdcm::VR;

/// Series, frame of reference and equipment modules; type 2 attributes are empty.
void putSeries(gdcm::DataSet& data, const DicomSeriesIdentity& identity, const SeriesUids& uids) {
  put(data, Tag(0x0008, 0x0060), VR::CS, "CT");
  put(data, Tag(0x0020, 0x000e), VR::UI, uids.series);
  put(data, Tag(0x0020, 0x0011), VR::IS, "1");
  put(data, Tag(0x0020, 0x0060), VR::CS, "");
  put(data, Tag(0x0018, 0x5100), VR::CS, "HFS");
  if (!identity.description.empty()) put(data, Tag(0x0008, 0x103e), VR::LO, identity.description.substr(0, 64));
  put(data, Tag(0x0020, 0x0052), VR::UI, uids.frameOfReference);
  put(data, Tag(0x0020, 0x1040), VR::LO, "");
  put(data, Tag(0x0008, 0x0070), VR::LO, "Insonate");
}

/// Image plane, image pixel and CT image modules.
void putSlice(gdcm::DataSet& data, const CtVolume& ct, int k) {
  const VolumeGeometry& g = ct.geometry;
  const Vec3 i = g.direction.column[0], j = g.direction.column[1];
  const Vec3 p = g.patientFromIndex() * Vec3{0, 0, static_cast<double>(k)};
  put(data, Tag(0x0020, 0x0013), VR::IS, std::to_string(k + 1));
  put(data, Tag(0x0020, 0x0012), VR::IS, "1");
  put(data, Tag(0x0020, 0x0032), VR::DS, decimalStrings({p.x, p.y, p.z}));
  put(data, Tag(0x0020, 0x0037), VR::DS, decimalStrings({i.x, i.y, i.z, j.x, j.y, j.z}));
  put(data, Tag(0x0028, 0x0030), VR::DS, decimalStrings({g.spacing_mm.y, g.spacing_mm.x}));
  put(data, Tag(0x0018, 0x0050), VR::DS, decimalStrings({g.spacing_mm.z}));
  put(data, Tag(0x0008, 0x0008), VR::CS, "ORIGINAL\\PRIMARY\\AXIAL");
  put(data, Tag(0x0018, 0x0060), VR::DS, "120");
  put(data, Tag(0x0028, 0x1052), VR::DS, "0");
  put(data, Tag(0x0028, 0x1053), VR::DS, "1");
  put(data, Tag(0x0028, 0x1054), VR::LO, "HU");
  put(data, Tag(0x0028, 0x0004), VR::CS, "MONOCHROME2");
  const auto rows = static_cast<std::uint16_t>(g.size[1]), columns = static_cast<std::uint16_t>(g.size[0]);
  for (const auto& [element, value] : {std::pair<std::uint16_t, std::uint16_t>{0x0002, 1},
                                       {0x0010, rows},
                                       {0x0011, columns},
                                       {0x0100, 16},
                                       {0x0101, 16},
                                       {0x0102, 15},
                                       {0x0103, 1}})
    putShorts(data, Tag(0x0028, element), {value});
  const std::size_t sliceSize = static_cast<std::size_t>(g.size[0]) * g.size[1];
  gdcm::DataElement pixels(Tag(0x7fe0, 0x0010));
  pixels.SetVR(VR::OW);
  pixels.SetByteValue(reinterpret_cast<const char*>(&ct.voxels[k * sliceSize]),
                      gdcm::VL(static_cast<std::uint32_t>(sliceSize * sizeof(std::int16_t))));
  data.Replace(pixels);
}

/// Makes one Part 10 file in memory, so that the caller that writes it notices a full disk.
Result<std::string> encodeSlice(const CtVolume& ct, int k, const DicomSeriesIdentity& identity,
                                const SeriesUids& uids) {
  gdcm::Writer writer;
  gdcm::DataSet& data = writer.GetFile().GetDataSet();
  put(data, Tag(0x0008, 0x0016), VR::UI, kCtImageStorage);
  put(data, Tag(0x0008, 0x0018), VR::UI, sliceUid(uids, k));
  putPatientAndStudy(data, identity, uids);
  putSeries(data, identity, uids);
  putSlice(data, ct, k);
  gdcm::FileMetaInformation& header = writer.GetFile().GetHeader();
  header.SetDataSetTransferSyntax(gdcm::TransferSyntax::ExplicitVRLittleEndian);
  std::ostringstream bytes;
  writer.SetStream(bytes);
  if (!writer.Write()) return fail("Slice " + std::to_string(k + 1) + " could not be encoded as DICOM.");
  return std::move(bytes).str();
}

Result<void> checkTarget(const CtVolume& ct, const fs::path& folder) {
  if (auto ok = validate(ct.geometry); !ok) return ok;
  if (ct.geometry.size[0] > 65535 || ct.geometry.size[1] > 65535)
    return fail("A DICOM slice holds at most 65535 rows and columns.");
  return checkDicomTarget(folder);
}

}  // namespace

Result<void> checkDicomTarget(const fs::path& folder) {
  if (auto ok = checkFolderTarget(folder); !ok) return ok;
  std::error_code error;
  if (fs::exists(folder, error) && (!fs::is_empty(folder, error) || error))
    return fail("The folder " + folder.string() +
                " is not empty, and slices of two series must not mix. Name another folder.");
  return {};
}

Result<void> writeDicomSeries(const CtVolume& ct, const fs::path& folder, const DicomSeriesIdentity& identity,
                              const Progress& progress) {
  if (auto ok = checkTarget(ct, folder); !ok) return ok;
  gdcm::Trace::WarningOff();
  gdcm::Trace::ErrorOff();
  const SeriesUids uids = uidsOf(identity);
  const int count = ct.geometry.size[2];
  auto written = writeFolderAtomically(folder, [&](const fs::path& beside) -> Result<void> {
    for (int k = 0; k < count; ++k) {
      if (!report(progress, "Writing DICOM", static_cast<double>(k) / count)) return fail(std::string(kCancelled));
      const auto bytes = encodeSlice(ct, k, identity, uids);
      if (!bytes) return tl::unexpected(bytes.error());
      std::array<char, 24> name;
      std::snprintf(name.data(), name.size(), "slice%05d.dcm", k + 1);
      if (auto ok = writeAtomically(beside / name.data(), *bytes); !ok) return ok;
    }
    return {};
  });
  if (written) report(progress, "Writing DICOM", 1);
  return written;
}

}  // namespace insonate
