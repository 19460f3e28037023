# insonate_vendor_kits(TARGET name...)
# Gives TARGET the list of the vendors' kits that it is built with: for each name a makeVendorKit_name() is called, which
# the site's sources define.
set(INSONATE_VENDOR_KITS_IN ${CMAKE_CURRENT_LIST_DIR}/VendorKits.cpp.in CACHE INTERNAL "")
function(insonate_vendor_kits TARGET)
  set(VENDOR_KIT_DECLARATIONS)
  set(VENDOR_KIT_CALLS)
  foreach(name IN LISTS ARGN)
    string(APPEND VENDOR_KIT_DECLARATIONS "std::unique_ptr<VendorKit> makeVendorKit_${name}();\n")
    string(APPEND VENDOR_KIT_CALLS "  kits.push_back(makeVendorKit_${name}());\n")
  endforeach()
  configure_file(${INSONATE_VENDOR_KITS_IN} ${CMAKE_CURRENT_BINARY_DIR}/VendorKits.cpp @ONLY)
  # By itself: a program with kits of its own defines the same function in place of the library's.
  set_source_files_properties(${CMAKE_CURRENT_BINARY_DIR}/VendorKits.cpp TARGET_DIRECTORY ${TARGET} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  target_sources(${TARGET} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/VendorKits.cpp)
endfunction()
