#include "VolumeFile.h"

#include "NiftiFile.h"
#include "NrrdField.h"
#include "WholeFile.h"

#include <itkMetaDataObject.h>
#include <itkMetaImageIO.h>
#include <itkNrrdImageIO.h>

#include <algorithm>
#include <cctype>
#include <new>

namespace insonate {
namespace fs = std::filesystem;
namespace {

using Io = itk::ImageIOBase;

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string lowerName(const fs::path& file) {
  return lower(file.filename().string());
}

bool endsWith(const std::string& name, std::initializer_list<const char*> endings) {
  return std::ranges::any_of(endings, [&](const char* e) { return name.ends_with(e); });
}

bool isNrrd(const std::string& name) {
  return endsWith(name, {".nrrd", ".nhdr"});
}
bool isNifti(const std::string& name) {
  return endsWith(name, {".nii", ".nii.gz"});
}
bool isMeta(const std::string& name) {
  return endsWith(name, {".mha", ".mhd"});
}

Io::Pointer makeIo(const fs::path& file) {
  const std::string name = lowerName(file);
  if (isNrrd(name)) return itk::NrrdImageIO::New().GetPointer();
  return itk::MetaImageIO::New().GetPointer();
}

/// The innermost reason of nested reader errors, without class names and addresses.
std::string innermost(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  while (!text.empty() && text.back() == ' ') text.pop_back();
  const std::size_t teem = text.rfind("[nrrd] ");
  // MetaIO reports this text for everything that it does not understand.
  if (text.find("No such file") != std::string::npos) return "its header is not understood";
  const std::size_t from = text.find(": ", teem == std::string::npos ? text.rfind("0x") : teem);
  if (from != std::string::npos) text.erase(0, from + 2);
  if (text.size() > 200) text = text.substr(0, 200) + "...";
  return text;
}

/// ITK converts the three spaces of NRRD that name the patient's directions to LPS and names them so, but ITK 5.2
/// rotates "left-anterior-superior" about the wrong axis: it flips the first axis instead of the second.
void takeNrrdSpace(const fs::path& file, RawVolume& raw) {
  const auto said = raw.metadata.find("NRRD_space");
  raw.oriented = said != raw.metadata.end() && said->second == "left-posterior-superior";
  const std::string space = lower(nrrdField(file, "space"));
  if (space != "left-anterior-superior" && space != "las") return;
  const Mat3 halfTurn{{{{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}}}};
  raw.patientFromIndex = Transform{halfTurn, {}} * raw.patientFromIndex;
}

Result<RawVolume> headerOf(const Io& io, const fs::path& file) {
  RawVolume raw;
  const unsigned dimensions = io.GetNumberOfDimensions();
  for (unsigned a = 3; a < dimensions; ++a)
    if (io.GetDimensions(a) > 1)
      return fail(file.string() + " has " + std::to_string(dimensions) +
                  " dimensions, e.g. time; export one three-dimensional volume of it.");
  const unsigned axes = std::min(dimensions, 3U);
  for (unsigned a = 0; a < axes; ++a) {
    if (io.GetDimensions(a) < 1 || io.GetDimensions(a) > 100000)
      return fail(file.string() + " states that it has " + std::to_string(io.GetDimensions(a)) +
                  " voxels along one axis.");
    raw.size[a] = static_cast<int>(io.GetDimensions(a));
    const auto axis = io.GetDirection(a);
    Vec3 direction;
    for (unsigned c = 0; c < axes; ++c) direction[static_cast<int>(c)] = axis[c];
    raw.patientFromIndex.linear.column[a] = direction * io.GetSpacing(a);
    raw.patientFromIndex.offset[static_cast<int>(a)] = io.GetOrigin(a);
  }
  constexpr unsigned kMaxComponents = 10000;
  if (io.GetNumberOfComponents() > kMaxComponents)
    return fail(file.string() + " states that it has " + std::to_string(io.GetNumberOfComponents()) +
                " values per voxel. It is damaged, or the order of its axes differs from their names.");
  raw.components = static_cast<int>(io.GetNumberOfComponents());
  raw.eightBit = io.GetComponentSize() == 1;
  for (const std::string& key : io.GetMetaDataDictionary().GetKeys()) {
    std::string value;
    if (itk::ExposeMetaData(io.GetMetaDataDictionary(), key, value)) raw.metadata[key] = value;
  }
  if (isNrrd(lowerName(file))) takeNrrdSpace(file, raw);
  return raw;
}

template <class T>
void copyAs(const std::vector<char>& bytes, std::vector<float>& values) {
  const T* source = reinterpret_cast<const T*>(bytes.data());
  std::transform(source, source + values.size(), values.begin(), [](T v) { return static_cast<float>(v); });
}

bool convert(Io::IOComponentEnum type, const std::vector<char>& bytes, std::vector<float>& values) {
  switch (type) {
    case Io::IOComponentEnum::CHAR:
      copyAs<signed char>(bytes, values);
      return true;
    case Io::IOComponentEnum::UCHAR:
      copyAs<unsigned char>(bytes, values);
      return true;
    case Io::IOComponentEnum::SHORT:
      copyAs<short>(bytes, values);
      return true;
    case Io::IOComponentEnum::USHORT:
      copyAs<unsigned short>(bytes, values);
      return true;
    case Io::IOComponentEnum::INT:
      copyAs<int>(bytes, values);
      return true;
    case Io::IOComponentEnum::UINT:
      copyAs<unsigned>(bytes, values);
      return true;
    case Io::IOComponentEnum::LONG:
      copyAs<long>(bytes, values);
      return true;
    case Io::IOComponentEnum::ULONG:
      copyAs<unsigned long>(bytes, values);
      return true;
    case Io::IOComponentEnum::LONGLONG:
      copyAs<long long>(bytes, values);
      return true;
    case Io::IOComponentEnum::ULONGLONG:
      copyAs<unsigned long long>(bytes, values);
      return true;
    case Io::IOComponentEnum::FLOAT:
      copyAs<float>(bytes, values);
      return true;
    case Io::IOComponentEnum::DOUBLE:
      copyAs<double>(bytes, values);
      return true;
    default:
      return false;
  }
}

/// The MetaImage reader treats missing voxels as zeros, and the NRRD reader allocates all memory that a header states.
Result<void> checkWhole(const RawVolume& raw, const Io& io, const fs::path& file) {
  const double promised = double(raw.size[0]) * raw.size[1] * raw.size[2] * raw.components * io.GetComponentSize();
  return isMeta(lowerName(file)) ? checkWholeMetaImage(file, promised) : checkWholeNrrd(file, promised);
}

Result<void> readValues(Io& io, const fs::path& file, RawVolume& raw) {
  constexpr double kMaxValues = 4e9;
  const double count = double(raw.size[0]) * raw.size[1] * raw.size[2] * raw.components;
  if (count > kMaxValues) return fail(file.string() + " states that it has more voxels than Insonate can handle.");
  itk::ImageIORegion region(io.GetNumberOfDimensions());
  for (unsigned a = 0; a < io.GetNumberOfDimensions(); ++a) region.SetSize(a, io.GetDimensions(a));
  io.SetIORegion(region);
  std::vector<char> bytes(static_cast<std::size_t>(count) * io.GetComponentSize());
  io.Read(bytes.data());
  raw.values.resize(static_cast<std::size_t>(count));
  if (!convert(io.GetComponentType(), bytes, raw.values))
    return fail(file.string() +
                " has voxels of a number type that Insonate cannot read. Convert it to 16-bit integers.");
  return {};
}

}  // namespace

bool isVolumeFile(const fs::path& file) {
  const std::string name = lowerName(file);
  return isNrrd(name) || isNifti(name) || isMeta(name);
}

Result<RawVolume> readVolumeFile(const fs::path& file, ReadPart part) {
  std::error_code error;
  if (!fs::exists(file, error)) return fail("There is no file " + file.string() + ".");
  if (!isVolumeFile(file))
    return fail(file.string() + " is not a volume this program reads (NRRD, NIfTI or MetaImage, by its name).");
  const std::string sentence =
      "Could not read " + file.string() + ": it may be damaged or cut off; copy or export it again. The reader says: ";
  try {
    if (isNifti(lowerName(file))) return readNifti(file, part);
    if (isMeta(lowerName(file)))
      if (auto ok = checkMetaImageHeader(file); !ok) return tl::unexpected(ok.error());
    const Io::Pointer io = makeIo(file);
    io->SetFileName(file.string());
    io->ReadImageInformation();
    auto raw = headerOf(*io, file);
    if (!raw || part == ReadPart::kHeader) return raw;
    if (auto ok = checkVoxelSize(spacingOf(*raw)); !ok) return fail(file.string() + ": " + ok.error().message);
    if (auto ok = checkWhole(*raw, *io, file); !ok) return tl::unexpected(ok.error());
    if (auto ok = readValues(*io, file, *raw); !ok) return tl::unexpected(ok.error());
    return raw;
  } catch (const itk::ExceptionObject& e) {
    return fail(sentence + innermost(e.GetDescription()));
  } catch (const std::bad_alloc&) {
    return fail("Could not read " + file.string() + ": there is not enough memory. Close other programs.");
  } catch (const std::exception& e) {
    return fail(sentence + innermost(e.what()));
  }
}

Result<RawVolume> readVolumeBlocks(const fs::path& file, const ValueSink& sink) {
  auto header = readVolumeFile(file, ReadPart::kHeader);
  if (!header) return header;
  if (header->components != 1)
    return fail(file.string() + " has " + std::to_string(header->components) +
                " values per voxel, e.g. color; a mask has one.");
  if (isNifti(lowerName(file))) return readNiftiBlocks(file, sink);
  auto raw = readVolumeFile(file);
  if (!raw) return raw;
  sink(0, raw->values);
  raw->values = {};
  return raw;
}

Vec3 spacingOf(const RawVolume& raw) {
  const auto& step = raw.patientFromIndex.linear.column;
  return {norm(step[0]), norm(step[1]), norm(step[2])};
}

Result<VolumeGeometry> orthogonalGeometry(const RawVolume& raw) {
  VolumeGeometry g;
  g.size = raw.size;
  g.origin_mm = raw.patientFromIndex.offset;
  g.spacing_mm = spacingOf(raw);
  for (int a = 0; a < 3; ++a)
    if (g.spacing_mm[a] > 0) g.direction.column[a] = raw.patientFromIndex.linear.column[a] / g.spacing_mm[a];
  if (auto ok = validate(g); !ok) return tl::unexpected(ok.error());
  return g;
}

}  // namespace insonate
