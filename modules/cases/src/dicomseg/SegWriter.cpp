#include "../import/DerivedUid.h"
#include "../import/DicomEncoding.h"
#include "CieLab.h"
#include "SegReader.h"

#include <insonate/cases/DicomSegmentation.h>
#include <insonate/core/AtomicFile.h>
#include <insonate/core/Fingerprint.h>
#include <insonate/tissue/Labels.h>

#include <gdcmTrace.h>
#include <gdcmWriter.h>

#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <span>
#include <sstream>

namespace insonate {
namespace fs = std::filesystem;
namespace {

using gdcm::DataSet;
using gdcm::Tag;
using gdcm::VR;

constexpr const char* kSegmentationStorage = "1.2.840.10008.5.1.4.1.1.66.4";

/// One slice of one structure.
struct SegmentFrame {
  int segment = 0;  ///< index among SegmentFrames::labels
  int k = 0;
};

/// A label map as DICOM stores it: one bit per voxel, frame after frame without gaps (PS3.5 8.1.1), the first pixel in
/// the lowest bit.
struct SegmentFrames {
  std::vector<std::uint8_t> labels;  ///< labels that occur, ascending
  std::vector<SegmentFrame> frames;  ///< slices in which a structure occurs, by structure, then by k
  std::vector<std::uint8_t> bits;
};

using Slice = std::span<const std::uint8_t>;

Slice sliceOf(const LabelMap& map, int k) {
  const std::size_t size = static_cast<std::size_t>(map.geometry.size[0]) * map.geometry.size[1];
  return {map.voxels.data() + static_cast<std::size_t>(k) * size, size};
}

/// Appends a frame behind the first `used` bits.
void addBits(Slice slice, std::uint8_t label, std::size_t used, std::vector<std::uint8_t>& bits) {
  bits.resize((used + slice.size() + 7) / 8);
  for (std::size_t n = 0; n < slice.size(); ++n)
    if (slice[n] == label) bits[(used + n) / 8] |= static_cast<std::uint8_t>(1U << ((used + n) % 8));
}

/// Converts a label map to frames; fails only when cancelled.
Result<SegmentFrames> framesOfLabels(const LabelMap& map, const Progress& progress) {
  const int slices = map.geometry.size[2];
  std::vector<std::array<bool, 256>> occurs(static_cast<std::size_t>(slices));
  std::array<bool, 256> anywhere{};
  for (int k = 0; k < slices; ++k)
    for (const std::uint8_t label : sliceOf(map, k))
      anywhere[label] = occurs[static_cast<std::size_t>(k)][label] = true;

  SegmentFrames result;
  std::size_t used = 0;
  for (int label = 1; label < 256; ++label) {
    if (!anywhere[label]) continue;
    if (!report(progress, "Writing the segmentation", label / 256.0)) return fail(std::string(kCancelled));
    const auto number = static_cast<std::uint8_t>(label);
    for (int k = 0; k < slices; ++k) {
      if (!occurs[static_cast<std::size_t>(k)][label]) continue;
      result.frames.push_back({static_cast<int>(result.labels.size()), k});
      addBits(sliceOf(map, k), number, used, result.bits);
      used += sliceOf(map, k).size();
    }
    result.labels.push_back(number);
  }
  return result;
}

struct Uids {
  SeriesUids ct;
  std::string series, instance, dimensions;
};

DataSet codeItem(const char* value, const char* scheme, const std::string& meaning) {
  DataSet item;
  put(item, Tag(0x0008, 0x0100), VR::SH, value);
  put(item, Tag(0x0008, 0x0102), VR::SH, scheme);
  put(item, Tag(0x0008, 0x0104), VR::LO, meaning);
  return item;
}

/// A label of the author has its own name, and the code of its tissue.
DataSet segmentItem(std::uint8_t label, std::uint16_t number, const PatientCase& patient) {
  DataSet item;
  const OwnLabels& own = patient.manifest.ownLabels;
  const std::uint8_t tissue = tissueOf(own, label);
  const bool coded = tissue < kLabelCount;
  const LabelInfo& info = labelTable()[knownLabel(tissue)];
  putSequence(item, Tag(0x0062, 0x0003), {codeItem("85756007", "SCT", "Tissue")});
  putShorts(item, Tag(0x0062, 0x0004), {number});
  put(item, Tag(0x0062, 0x0005), VR::LO, labelName(own, label));
  put(item, Tag(0x0062, 0x0008), VR::CS, "SEMIAUTOMATIC");
  put(item, Tag(0x0062, 0x0009), VR::LO, kAlgorithm);
  const DicomLab lab = dicomLabOf(caseLabelColor(patient.colors, label));
  putShorts(item, Tag(0x0062, 0x000d), {lab[0], lab[1], lab[2]});
  putSequence(item, Tag(0x0062, 0x000f),
              {coded ? codeItem(std::string(info.snomedCode).c_str(), "SCT", std::string(info.snomedMeaning))
                     : codeItem("85756007", "SCT", "Tissue")});
  return item;
}

DataSet reference(const std::string& instance) {
  DataSet item;
  put(item, Tag(0x0008, 0x1150), VR::UI, kCtImageStorage);
  put(item, Tag(0x0008, 0x1155), VR::UI, instance);
  return item;
}

DataSet dimension(const Uids& uids, Tag pointer, Tag group, const char* description) {
  DataSet item;
  const auto putTag = [&](Tag tag, Tag value) {
    const std::uint16_t words[2] = {value.GetGroup(), value.GetElement()};
    putBinary(item, tag, VR::AT, words, sizeof words);
  };
  put(item, Tag(0x0020, 0x9164), VR::UI, uids.dimensions);
  putTag(Tag(0x0020, 0x9165), pointer);
  putTag(Tag(0x0020, 0x9167), group);
  put(item, Tag(0x0020, 0x9421), VR::LO, description);
  return item;
}

/// Series and equipment modules, and the time of creation (PS3.3 A.51.3).
void putSeries(DataSet& data, const Uids& uids) {
  put(data, Tag(0x0008, 0x0005), VR::CS, "ISO_IR 192");  // UTF-8, for names
  put(data, Tag(0x0008, 0x0016), VR::UI, kSegmentationStorage);
  put(data, Tag(0x0008, 0x0018), VR::UI, uids.instance);
  putTimeOfWriting(data);
  put(data, Tag(0x0008, 0x0060), VR::CS, "SEG");
  put(data, Tag(0x0008, 0x0070), VR::LO, "Insonate");
  put(data, Tag(0x0008, 0x103e), VR::LO, "Segmentation");
  put(data, Tag(0x0008, 0x1090), VR::LO, "Insonate");
  put(data, Tag(0x0018, 0x1000), VR::LO, "0");
  put(data, Tag(0x0018, 0x1020), VR::LO, INSONATE_VERSION);
  put(data, Tag(0x0020, 0x000e), VR::UI, uids.series);
  put(data, Tag(0x0020, 0x0011), VR::IS, "2");
  put(data, Tag(0x0020, 0x0013), VR::IS, "1");
  put(data, Tag(0x0020, 0x0052), VR::UI, uids.ct.frameOfReference);
  put(data, Tag(0x0020, 0x1040), VR::LO, "");
}

void putDimensions(DataSet& data, const Uids& uids) {
  DataSet organization;
  put(organization, Tag(0x0020, 0x9164), VR::UI, uids.dimensions);
  putSequence(data, Tag(0x0020, 0x9221), {organization});
  putSequence(data, Tag(0x0020, 0x9222),
              {dimension(uids, Tag(0x0062, 0x000b), Tag(0x0062, 0x000a), "ReferencedSegmentNumber"),
               dimension(uids, Tag(0x0020, 0x0032), Tag(0x0020, 0x9113), "ImagePositionPatient")});
}

/// Segmentation image module (PS3.3 C.8.20.2).
void putImage(DataSet& data, const PatientCase& patient, const SegmentFrames& packed) {
  const VolumeGeometry& g = patient.labels.geometry;
  put(data, Tag(0x0008, 0x0008), VR::CS, "DERIVED\\PRIMARY");
  put(data, Tag(0x0028, 0x0004), VR::CS, "MONOCHROME2");
  put(data, Tag(0x0028, 0x0008), VR::IS, std::to_string(packed.frames.size()));
  putShorts(data, Tag(0x0028, 0x0002), {1});
  putShorts(data, Tag(0x0028, 0x0010), {static_cast<std::uint16_t>(g.size[1])});
  putShorts(data, Tag(0x0028, 0x0011), {static_cast<std::uint16_t>(g.size[0])});
  for (const auto& [element, value] :
       {std::pair<std::uint16_t, std::uint16_t>{0x0100, 1}, {0x0101, 1}, {0x0102, 0}, {0x0103, 0}})
    putShorts(data, Tag(0x0028, element), {value});
  put(data, Tag(0x0028, 0x2110), VR::CS, "00");
  put(data, Tag(0x0062, 0x0001), VR::CS, "BINARY");
  std::vector<DataSet> segments;
  for (std::size_t n = 0; n < packed.labels.size(); ++n)
    segments.push_back(segmentItem(packed.labels[n], static_cast<std::uint16_t>(n + 1), patient));
  putSequence(data, Tag(0x0062, 0x0002), segments);
  put(data, Tag(0x0070, 0x0080), VR::CS, "SEGMENTATION");
  put(data, Tag(0x0070, 0x0081), VR::LO, "");
  put(data, Tag(0x0070, 0x0084), VR::PN, "");
}

/// References the labeled CT as writeDicomSeries names it.
void putReferences(DataSet& data, const VolumeGeometry& g, const Uids& uids) {
  DataSet series;
  std::vector<DataSet> instances;
  for (int k = 0; k < g.size[2]; ++k) instances.push_back(reference(sliceUid(uids.ct, k)));
  putSequence(series, Tag(0x0008, 0x114a), instances);
  put(series, Tag(0x0020, 0x000e), VR::UI, uids.ct.series);
  putSequence(data, Tag(0x0008, 0x1115), {series});
}

DataSet sharedGroups(const VolumeGeometry& g) {
  const Vec3 i = g.direction.column[0], j = g.direction.column[1];
  DataSet orientation, measures, shared;
  put(orientation, Tag(0x0020, 0x0037), VR::DS, decimalStrings({i.x, i.y, i.z, j.x, j.y, j.z}));
  put(measures, Tag(0x0018, 0x0050), VR::DS, decimalStrings({g.spacing_mm.z}));
  put(measures, Tag(0x0018, 0x0088), VR::DS, decimalStrings({g.spacing_mm.z}));
  put(measures, Tag(0x0028, 0x0030), VR::DS, decimalStrings({g.spacing_mm.y, g.spacing_mm.x}));
  putSequence(shared, Tag(0x0020, 0x9116), {orientation});
  putSequence(shared, Tag(0x0028, 0x9110), {measures});
  return shared;
}

DataSet frameGroups(const VolumeGeometry& g, const SegmentFrame& frame, const Uids& uids) {
  const Vec3 p = g.patientFromIndex() * Vec3{0, 0, static_cast<double>(frame.k)};
  DataSet source = reference(sliceUid(uids.ct, frame.k));
  putSequence(source, Tag(0x0040, 0xa170), {codeItem("121322", "DCM", "Source image for image processing operation")});
  DataSet derivation, content, position, segment, groups;
  putSequence(derivation, Tag(0x0008, 0x2112), {source});
  putSequence(derivation, Tag(0x0008, 0x9215), {codeItem("113076", "DCM", "Segmentation")});
  const std::uint32_t place[2] = {static_cast<std::uint32_t>(frame.segment + 1),
                                  static_cast<std::uint32_t>(frame.k + 1)};
  putBinary(content, Tag(0x0020, 0x9157), VR::UL, place, sizeof place);
  put(position, Tag(0x0020, 0x0032), VR::DS, decimalStrings({p.x, p.y, p.z}));
  putShorts(segment, Tag(0x0062, 0x000b), {static_cast<std::uint16_t>(frame.segment + 1)});
  putSequence(groups, Tag(0x0008, 0x9124), {derivation});
  putSequence(groups, Tag(0x0020, 0x9111), {content});
  putSequence(groups, Tag(0x0020, 0x9113), {position});
  putSequence(groups, Tag(0x0062, 0x000a), {segment});
  return groups;
}

Result<std::string> encode(const PatientCase& patient, SegmentFrames packed) {
  static_assert(std::endian::native == std::endian::little, "numbers are written as they lie in memory");
  const DicomSeriesIdentity identity = dicomIdentityOf(patient);
  Fingerprint bits;
  bits.add(std::string_view(reinterpret_cast<const char*>(packed.bits.data()), packed.bits.size()));
  const std::string seed = identity.seed + "/segmentation/" + bits.text();
  const Uids uids{uidsOf(identity), derivedUid(seed + "/series"), derivedUid(seed + "/instance"),
                  derivedUid(seed + "/dimensions")};
  gdcm::Writer writer;
  DataSet& data = writer.GetFile().GetDataSet();
  putPatientAndStudy(data, identity, uids.ct);
  putSeries(data, uids);
  putDimensions(data, uids);
  putImage(data, patient, packed);
  putReferences(data, patient.labels.geometry, uids);
  putSequence(data, Tag(0x5200, 0x9229), {sharedGroups(patient.labels.geometry)});
  std::vector<DataSet> groups;
  for (const SegmentFrame& frame : packed.frames) groups.push_back(frameGroups(patient.labels.geometry, frame, uids));
  putSequence(data, Tag(0x5200, 0x9230), groups);
  if (packed.bits.size() % 2) packed.bits.push_back(0);
  putBinary(data, Tag(0x7fe0, 0x0010), VR::OB, packed.bits.data(), packed.bits.size());
  writer.GetFile().GetHeader().SetDataSetTransferSyntax(gdcm::TransferSyntax::ExplicitVRLittleEndian);
  std::ostringstream bytes;
  writer.SetStream(bytes);
  if (!writer.Write()) return fail("The labels could not be encoded as a DICOM segmentation.");
  return std::move(bytes).str();
}

}  // namespace

DicomSeriesIdentity dicomIdentityOf(const PatientCase& patient) {
  Fingerprint print;
  for (const std::int16_t hu : patient.ct.voxels) print.add(static_cast<std::uint16_t>(hu));
  const VolumeGeometry& g = patient.ct.geometry;
  for (const int n : g.size) print.add(static_cast<std::uint64_t>(n));
  for (const Vec3 v : {g.spacing_mm, g.origin_mm, g.direction.column[0], g.direction.column[1], g.direction.column[2]})
    for (int a = 0; a < 3; ++a) print.add(std::bit_cast<std::uint64_t>(v[a]));
  return {.seed = "case/" + print.text(), .patientName = "Insonate^Case", .patientId = print.text()};
}

Result<void> writeDicomSegmentation(const PatientCase& patient, const fs::path& file, const Progress& progress) {
  const VolumeGeometry& g = patient.labels.geometry;
  if (auto ok = validate(g); !ok) return ok;
  if (g.size[0] > 65535 || g.size[1] > 65535) return fail("A DICOM segmentation holds at most 65535 rows and columns.");
  gdcm::Trace::WarningOff();
  gdcm::Trace::ErrorOff();
  auto packed = framesOfLabels(patient.labels, progress);
  if (!packed) return tl::unexpected(packed.error());
  if (packed->labels.empty())
    return fail("Nothing is labeled, so there is no segmentation to write to " + file.string() + ".");
  if (packed->bits.size() > std::numeric_limits<std::uint32_t>::max() - 2)
    return fail("The labels need more than 4 GB as one DICOM segmentation. Crop the case first.");
  const auto bytes = encode(patient, std::move(*packed));
  if (!bytes) return tl::unexpected(bytes.error());
  if (!report(progress, "Writing the segmentation", 1)) return fail(std::string(kCancelled));
  return writeAtomically(file, *bytes);
}

}  // namespace insonate
