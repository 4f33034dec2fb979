#include "striate/memory/long_term/damage.hpp"

#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>

#include "striate/base/plain_text.hpp"
#include "striate/base/shell_text.hpp"
#include "striate/memory/long_term/view_codec.hpp"

namespace striate::memory {
namespace {

void check_pages(SQLite::Database& database, std::vector<std::string>& damage) {
  SQLite::Statement pages(database, "PRAGMA integrity_check");
  while (pages.executeStep()) {
    const std::string line = pages.getColumn(0).getString();
    if (line != "ok") {
      damage.push_back("the file's structure: " + line +
                       "; restore a copy, or export what is left and import it into a new memory");
    }
  }
  SQLite::Statement references(database, "PRAGMA foreign_key_check");
  while (references.executeStep()) {
    damage.push_back(fmt::format(
        "table {}: row {} refers to a {} that is not there", references.getColumn(0).getString(),
        references.getColumn(1).getString(), references.getColumn(2).getString()));
  }
}

void check_views(SQLite::Database& database, std::vector<std::string>& damage) {
  SQLite::Statement views(
      database,
      "SELECT v.id, coalesce(l.name, '?'), v.width_px, v.height_px, v.descriptors, v.keypoints, "
      "v.crc, v.picture, v.picture_crc FROM landmark_view v LEFT JOIN landmark l "
      "ON l.id = v.landmark ORDER BY v.id");
  while (views.executeStep()) {
    const std::string name = plain_text(views.getColumn(1).getString());
    const std::int64_t id = views.getColumn(0).getInt64();
    const bool good =
        checksum_of_view(views.getColumn(2).getDouble(), views.getColumn(3).getDouble(),
                         bytes_of(views.getColumn(4)), bytes_of(views.getColumn(5))) ==
        static_cast<std::uint32_t>(views.getColumn(6).getInt64());
    if (!good) {
      damage.push_back(fmt::format(
          "landmark '{}', view {}: descriptors or keypoints do not match their checksum; the view "
          "is not used; teach it again: striate teach {} --image PICTURE",
          name, id, shell_word(name)));
    }
    if (crc32c(bytes_of(views.getColumn(7))) !=
        static_cast<std::uint32_t>(views.getColumn(8).getInt64())) {
      damage.push_back(
          fmt::format("landmark '{}', view {}: its image does not match its "
                      "checksum; the view itself is used",
                      name, id));
    }
  }
}

}  // namespace

std::vector<std::string> find_damage(SQLite::Database& database) {
  std::vector<std::string> damage;
  try {
    check_pages(database, damage);
    check_views(database, damage);
  } catch (const SQLite::Exception& error) {
    damage.push_back(
        fmt::format("the file cannot be read to its end: {}; restore a copy, or "
                    "export what is left and import it into a new memory",
                    error.what()));
  }
  return damage;
}

}  // namespace striate::memory
