# Writes the dashboard's page as one C++ source: cmake -DFOLDER=... -DOUT=... -P assets.cmake
# A list of numbers, since a compiler need not take a literal of more than 64 KB.
file(GLOB files ${FOLDER}/*)
list(SORT files)
set(types ".html" "text/html" ".css" "text/css" ".js" "text/javascript" ".svg" "image/svg+xml" ".txt" "text/plain")
set(arrays "")
set(rows "")
set(index 0)
foreach(file IN LISTS files)
  get_filename_component(name ${file} NAME)
  get_filename_component(end ${file} LAST_EXT)
  list(FIND types ${end} at)
  if(at EQUAL -1)
    message(FATAL_ERROR "${file}: what type of file is this? cmake/assets.cmake lists those of the page")
  endif()
  math(EXPR at "${at} + 1")
  list(GET types ${at} type)
  file(READ ${file} hex HEX)
  string(REGEX REPLACE "(................................................................)" "\\1\n" hex "${hex}")
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," hex "${hex}")
  string(APPEND arrays "const char kAsset${index}[] = {\n${hex}'\\0'};\n")
  string(APPEND rows "    {\"/${name}\", \"${type}; charset=utf-8\", {kAsset${index}, sizeof(kAsset${index}) - 1}},\n")
  math(EXPR index "${index} + 1")
endforeach()
file(WRITE ${OUT}
"#include \"striate/viewer/dashboard/assets.hpp\"

#include <array>

namespace striate::viewer::dashboard {
namespace {

${arrays}
constexpr std::array<Asset, ${index}> kAssets{{
${rows}}};

}  // namespace

const Asset* find_asset(std::string_view path) {
  for (const Asset& asset : kAssets) {
    if (asset.path == path) return &asset;
  }
  return nullptr;
}

}  // namespace striate::viewer::dashboard
")
