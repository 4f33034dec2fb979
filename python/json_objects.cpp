#include "striate/python/json_objects.hpp"

#include "striate/python/texts.hpp"

namespace striate::python {
namespace {

namespace py = pybind11;

py::object list_object(const nlohmann::ordered_json& json) {
  py::list list;
  for (const auto& item : json) list.append(object_of(item));
  return list;
}

py::object dict_object(const nlohmann::ordered_json& json) {
  py::dict dict;
  for (const auto& [key, value] : json.items()) dict[text_of(key)] = object_of(value);
  return dict;
}

}  // namespace

py::object object_of(const nlohmann::ordered_json& json) {
  using Type = nlohmann::ordered_json::value_t;
  switch (json.type()) {
    case Type::object:
      return dict_object(json);
    case Type::array:
      return list_object(json);
    case Type::string:
      return text_of(json.get_ref<const std::string&>());
    case Type::boolean:
      return py::bool_(json.get<bool>());
    case Type::number_integer:
      return py::int_(json.get<std::int64_t>());
    case Type::number_unsigned:
      return py::int_(json.get<std::uint64_t>());
    case Type::number_float:
      return py::float_(json.get<double>());
    default:
      return py::none();
  }
}

}  // namespace striate::python
