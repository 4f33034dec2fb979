#include "striate/memory/long_term/memory_errors.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

#include "striate/base/user_error.hpp"

namespace striate::memory {
namespace {

const char* what_and_cure(int code) {
  switch (code) {
    case SQLITE_FULL:
      return "there is no room left; free some on the disk (or 'striate memory FILE prune') and do "
             "it again; what was kept before is unharmed";
    case SQLITE_READONLY:
    case SQLITE_PERM:
      return "the file or its folder cannot be written; make both writable, or copy the memory to "
             "a "
             "folder of yours";
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return "another program is writing to it; try again when that has ended";
    case SQLITE_NOTADB:
      return "this is no SQLite file, so it is no memory; name another file, or restore a copy";
    case SQLITE_CORRUPT:
      return "the file is damaged; see 'striate memory FILE check'; restore a copy, or save "
             "what can be read: 'striate memory FILE export SAVED.json', and then 'striate memory "
             "NEW import SAVED.json'";
    case SQLITE_CANTOPEN:
      return "it cannot be opened; is the path right, and may you read the file and its folder?";
    case SQLITE_IOERR:
      return "the disk failed while reading or writing; free room, check the disk, and try again";
    case SQLITE_CONSTRAINT:
      return "a value is not allowed there; nothing was changed";
    default:
      return "SQLite refused it";
  }
}

}  // namespace

bool is_damage(const SQLite::Exception& error) {
  const int code = error.getErrorCode() & kPrimaryCode;
  return code == SQLITE_CORRUPT || code == SQLITE_NOTADB || code == SQLITE_IOERR;
}

void throw_memory_error(const std::string& file, const std::string& doing,
                        const SQLite::Exception& error) {
  throw UserError(fmt::format("{}: error while {}: {}\n    {}", file, doing, error.what(),
                              what_and_cure(error.getErrorCode() & kPrimaryCode)));
}

}  // namespace striate::memory
