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
void takeNrrdSpace(const fs::path& file, VolumeHeader& raw) {
  const auto said = raw.metadata.find("NRRD_space");
  raw.oriented = said != raw.metadata.end() && said->second == "left-posterior-superior";
  const std::string space = lower(nrrdField(file, "space"));
  if (space != "left-anterior-superior" && space != "las") return;
  const Mat3 halfTurn{{{{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}}}};
  raw.patientFromIndex = Transform{halfTurn, {}} * raw.patientFromIndex;
}

Result<VolumeHeader> headerOf(const Io& io, const fs::path& file) {
  VolumeHeader raw;
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
void copyAs(const char* bytes, std::span<float> values) {
  const T* source = reinterpret_cast<const T*>(bytes);
  std::transform(source, source + values.size(), values.begin(), [](T v) { return static_cast<float>(v); });
}

using Copy = void (*)(const char* bytes, std::span<float> values);

/// Conversion from a number type; nullptr for a type that cannot be read.
Copy copyFrom(Io::IOComponentEnum type) {
  switch (type) {
    case Io::IOComponentEnum::CHAR:
      return copyAs<signed char>;
    case Io::IOComponentEnum::UCHAR:
      return copyAs<unsigned char>;
    case Io::IOComponentEnum::SHORT:
      return copyAs<short>;
    case Io::IOComponentEnum::USHORT:
      return copyAs<unsigned short>;
    case Io::IOComponentEnum::INT:
      return copyAs<int>;
    case Io::IOComponentEnum::UINT:
      return copyAs<unsigned>;
    case Io::IOComponentEnum::LONG:
      return copyAs<long>;
    case Io::IOComponentEnum::ULONG:
      return copyAs<unsigned long>;
    case Io::IOComponentEnum::LONGLONG:
      return copyAs<long long>;
    case Io::IOComponentEnum::ULONGLONG:
      return copyAs<unsigned long long>;
    case Io::IOComponentEnum::FLOAT:
      return copyAs<float>;
    case Io::IOComponentEnum::DOUBLE:
      return copyAs<double>;
    default:
      return nullptr;
  }
}

/// The MetaImage reader treats missing voxels as zeros, and the NRRD reader allocates all memory that a header states.
Result<void> checkWhole(const VolumeHeader& header, const Io& io, const fs::path& file) {
  const double promised =
      double(header.size[0]) * header.size[1] * header.size[2] * header.components * io.GetComponentSize();
  return isMeta(lowerName(file)) ? checkWholeMetaImage(file, promised) : checkWholeNrrd(file, promised);
}

Result<void> readValues(Io& io, const fs::path& file, const VolumeHeader& header, const ValueSink& sink) {
  constexpr double kMaxValues = 4e9;
  constexpr std::size_t kBlockVoxels = std::size_t{1} << 16;
  const double stated = double(header.size[0]) * header.size[1] * header.size[2] * header.components;
  if (stated > kMaxValues) return fail(file.string() + " states that it has more voxels than Insonate can handle.");
  const Copy copy = copyFrom(io.GetComponentType());
  if (!copy)
    return fail(file.string() +
                " has voxels of a number type that Insonate cannot read. Convert it to 16-bit integers.");
  itk::ImageIORegion region(io.GetNumberOfDimensions());
  for (unsigned a = 0; a < io.GetNumberOfDimensions(); ++a) region.SetSize(a, io.GetDimensions(a));
  io.SetIORegion(region);
  const auto count = static_cast<std::size_t>(stated);
  std::vector<char> bytes(count * io.GetComponentSize());
  io.Read(bytes.data());
  std::vector<float> block(kBlockVoxels * static_cast<std::size_t>(header.components));
  for (std::size_t first = 0; first < count; first += block.size()) {
    const auto values = std::span(block).first(std::min(block.size(), count - first));
    copy(bytes.data() + first * io.GetComponentSize(), values);
    sink(first, values);
  }
  return {};
}

/// Reads the header, and the values if there is a sink.
Result<VolumeHeader> readVolume(const fs::path& file, const ValueSink& sink) {
  std::error_code error;
  if (!fs::exists(file, error)) return fail("There is no file " + file.string() + ".");
  if (!isVolumeFile(file))
    return fail(file.string() + " is not a volume this program reads (NRRD, NIfTI or MetaImage, by its name).");
  const std::string sentence =
      "Could not read " + file.string() + ": it may be damaged or cut off; copy or export it again. The reader says: ";
  try {
    if (isNifti(lowerName(file))) return sink ? readNiftiBlocks(file, sink) : readNiftiHeader(file);
    if (isMeta(lowerName(file)))
      if (auto ok = checkMetaImageHeader(file); !ok) return tl::unexpected(ok.error());
    const Io::Pointer io = makeIo(file);
    io->SetFileName(file.string());
    io->ReadImageInformation();
    auto header = headerOf(*io, file);
    if (!header || !sink) return header;
    if (auto ok = checkVoxelSize(spacingOf(*header)); !ok) return fail(file.string() + ": " + ok.error().message);
    if (auto ok = checkWhole(*header, *io, file); !ok) return tl::unexpected(ok.error());
    if (auto ok = readValues(*io, file, *header, sink); !ok) return tl::unexpected(ok.error());
    return header;
  } catch (const itk::ExceptionObject& e) {
    return fail(sentence + innermost(e.GetDescription()));
  } catch (const std::bad_alloc&) {
    return fail("Could not read " + file.string() + ": there is not enough memory. Close other programs.");
  } catch (const std::exception& e) {
    return fail(sentence + innermost(e.what()));
  }
}

}  // namespace

bool isVolumeFile(const fs::path& file) {
  const std::string name = lowerName(file);
  return isNrrd(name) || isNifti(name) || isMeta(name);
}

Result<VolumeHeader> readVolumeHeader(const fs::path& file) {
  return readVolume(file, {});
}

Result<void> readVolumeBlocks(const fs::path& file, const ValueSink& sink) {
  const auto header = readVolume(file, sink);
  if (!header) return tl::unexpected(header.error());
  return {};
}

Vec3 spacingOf(const VolumeHeader& raw) {
  const auto& step = raw.patientFromIndex.linear.column;
  return {norm(step[0]), norm(step[1]), norm(step[2])};
}

Result<VolumeGeometry> orthogonalGeometry(const VolumeHeader& raw) {
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
