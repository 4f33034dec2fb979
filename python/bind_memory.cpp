#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <memory>
#include <opencv2/imgcodecs.hpp>

#include "striate/agent/landmark_list.hpp"
#include "striate/agent/memory_json.hpp"
#include "striate/base/user_error.hpp"
#include "striate/memory/long_term/forgetting.hpp"
#include "striate/python/arrays.hpp"
#include "striate/python/bindings.hpp"
#include "striate/python/json_objects.hpp"
#include "striate/python/memory_reader.hpp"

namespace striate::python {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using SharedView = std::shared_ptr<const memory::StoredView>;

/// Reads without the interpreter's lock, since another program may hold the file for a while.
template <class Work>
auto read_unlocked(MemoryReader& memory, const char* doing, Work work) {
  const py::gil_scoped_release unlocked;
  return memory.read(doing, work);
}

template <class Records>
ordered_json json_of(const Records& records) {
  ordered_json list = ordered_json::array();
  for (const auto& one : records) list.push_back(agent::to_json(one));
  return list;
}

py::list views(MemoryReader& memory, const std::string& name) {
  std::vector<memory::StoredView> found =
      read_unlocked(memory, "reading its views", [&](memory::MemoryTables& tables) {
        return tables.views.of(memory::find_landmark(tables, name).id);
      });
  py::list list;
  for (memory::StoredView& view : found) {
    list.append(std::make_shared<memory::StoredView>(std::move(view)));
  }
  return list;
}

py::object picture_of(const memory::StoredView& view) {
  if (view.image.empty()) return py::none();
  cv::Mat3b picture;
  {
    const py::gil_scoped_release unlocked;
    picture = cv::imdecode(view.image, cv::IMREAD_COLOR);
  }
  if (picture.empty()) throw UserError("the picture of this view cannot be decoded");
  return array_of(picture);
}

ordered_json json_of(const agent::KnownThing& thing) {
  ordered_json quad = ordered_json::array();
  for (const cv::Point2d& corner : thing.quad) quad.push_back({corner.x, corner.y});
  return {{"name", thing.name},
          {"view", thing.view},
          {"inliers", thing.inliers},
          {"score", thing.score},
          {"matched", thing.matched},
          {"scale", thing.scale},
          {"turned_rad", thing.turned_rad},
          {"quad", quad}};
}

py::object recognise(MemoryReader& memory, const py::object& image,
                     const std::vector<std::string>& only, const std::string& channels) {
  const cv::Mat3b picture = bgr_image(image, "image", channels_named(channels));
  ordered_json list = ordered_json::array();
  {
    const py::gil_scoped_release unlocked;
    for (const agent::KnownThing& thing : memory.recognise(picture, only)) {
      list.push_back(json_of(thing));
    }
  }
  return object_of(list);
}

void bind_view(py::module_& module) {
  using memory::StoredView;
  py::class_<StoredView, std::shared_ptr<StoredView>>(module, "View",
                                                      "One look at a landmark, as it was taught.")
      .def_readonly("id", &StoredView::id)
      .def_readonly("session", &StoredView::session, "In which it was learned.")
      .def_readonly("width_px", &StoredView::width_px, "Of the region that it shows.")
      .def_readonly("height_px", &StoredView::height_px, "Of the region that it shows.")
      .def_readonly("range_m", &StoredView::range_m, "From where it was seen; None: unknown.")
      .def_readonly("bearing_rad", &StoredView::bearing_rad, "The same; None: unknown.")
      .def_readonly("damaged", &StoredView::damaged,
                    "Its bytes do not match their checksum: it is not used.")
      .def_property_readonly(
          "descriptors",
          [](const SharedView& view) {
            return array_view(py::dtype::of<std::uint8_t>(),
                              {static_cast<py::ssize_t>(view->descriptors.size()), 32}, {32, 1},
                              view->descriptors.data(), view);
          },
          "(n, 32) uint8; bit b is bit b % 8 of byte b // 8.")
      .def_property_readonly(
          "keypoints", [](const SharedView& view) { return records_view(view->keypoints, view); },
          "Structured array (n,): x_px, y_px from the view's upper left pixel, size_px, angle_rad.")
      .def_property_readonly(
          "jpeg",
          [](const StoredView& view) {
            return py::bytes(reinterpret_cast<const char*>(view.image.data()), view.image.size());
          },
          "The picture's bytes as they are kept; empty: there is none.")
      .def("picture", &picture_of,
           "The picture decoded: (h, w, 3) uint8, BGR; None: there is none.\n\nRaises UserError "
           "where it cannot be decoded.");
}

template <class Class>
void add_memory_lists(Class& memory) {
  memory
      .def(
          "_landmarks",
          [](MemoryReader& reader, bool forgotten) {
            return object_of(
                read_unlocked(reader, "listing it", [forgotten](memory::MemoryTables& tables) {
                  return agent::to_json(agent::list_landmarks(tables, forgotten, {}));
                }));
          },
          py::arg("forgotten"))
      .def("_episodes",
           [](MemoryReader& reader, int most) {
             return object_of(read_unlocked(reader, "reading its episodes", [most](auto& tables) {
               return json_of(tables.sessions.episodes(most));
             }));
           })
      .def("_sessions",
           [](MemoryReader& reader) {
             return object_of(read_unlocked(reader, "reading its sessions", [](auto& tables) {
               return json_of(tables.sessions.all());
             }));
           })
      .def("_routes",
           [](MemoryReader& reader) {
             return object_of(read_unlocked(reader, "reading its routes", [](auto& tables) {
               return json_of(tables.places.routes());
             }));
           })
      .def("_obstacle_cells", [](MemoryReader& reader) {
        return object_of(read_unlocked(reader, "reading its map", [](auto& tables) {
          return json_of(tables.places.cells());
        }));
      });
}

}  // namespace

void bind_long_term_memory(py::module_& module) {
  bind_view(module);
  module.attr("OBSTACLE_CELL_M") = memory::kObstacleCell_m;
  py::class_<MemoryReader> memory(module, "_Memory");
  memory
      .def(py::init([](const fs::path& file) {
             const py::gil_scoped_release unlocked;
             return std::make_unique<MemoryReader>(file);
           }),
           py::arg("file"))
      .def("_views", &views, py::arg("name"))
      .def("_recognise", &recognise, py::arg("image"), py::arg("only"), py::arg("channels"))
      .def("close", &MemoryReader::close, py::call_guard<py::gil_scoped_release>())
      .def_property_readonly("path", &MemoryReader::path)
      .def_property_readonly("notices", &MemoryReader::notices)
      .def_property_readonly("closed", py::cpp_function(&MemoryReader::closed,
                                                        py::call_guard<py::gil_scoped_release>()));
  add_memory_lists(memory);
}

}  // namespace striate::python
