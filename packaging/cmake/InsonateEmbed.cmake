# insonate_embed(TARGET NAMESPACE file...)
# Compiles text files into TARGET, so that nothing has to be found at run time. The target's sources include
# <insonate/embedded/NAMESPACE.h> and get insonate::embedded::NAMESPACE::files(): name (without extension) and text of
# each file, in the order given. A changed file is picked up by the next build.
function(insonate_embed TARGET NAMESPACE)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/embedded)
  set(header "#pragma once\n\n#include <span>\n#include <string_view>\n\nnamespace insonate::embedded::${NAMESPACE} {
struct File {\n  std::string_view name, text;\n};\nstd::span<const File> files();\n}\n")
  set(source "#include <insonate/embedded/${NAMESPACE}.h>\n\nnamespace insonate::embedded::${NAMESPACE} {
namespace {\nconstexpr File kFiles[] = {\n")
  foreach(path IN LISTS ARGN)
    get_filename_component(path ${path} ABSOLUTE)
    get_filename_component(name ${path} NAME_WE)
    file(READ ${path} text)
    string(APPEND source "{\"${name}\", R\"__embedded__(${text})__embedded__\"},\n")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${path})
  endforeach()
  string(APPEND source "};\n}\nstd::span<const File> files() {\n  return kFiles;\n}\n}\n")
  # Copied over the used file only when different, so that configuring again compiles nothing again.
  foreach(kind header source)
    file(WRITE ${folder}/${NAMESPACE}.${kind}.new "${${kind}}")
  endforeach()
  configure_file(${folder}/${NAMESPACE}.header.new ${folder}/insonate/embedded/${NAMESPACE}.h COPYONLY)
  configure_file(${folder}/${NAMESPACE}.source.new ${folder}/${NAMESPACE}.cpp COPYONLY)
  target_sources(${TARGET} PRIVATE ${folder}/${NAMESPACE}.cpp)
  target_include_directories(${TARGET} PRIVATE ${folder})
endfunction()
