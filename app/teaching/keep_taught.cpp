#include "app/teaching/keep_taught.hpp"

#include "app/memory/open_memory.hpp"
#include "memory/long_term/memory_writer.hpp"

namespace striate {

Taught keep_taught(const std::string& memory, const std::string& name,
                   const std::vector<StoredView>& views, const LongTermSettings& settings) {
  const MemoryOptions opening = memory_options(Access::session, "striate teach");
  MemoryWriter writer(memory, opening);
  print_notices(writer.notices());
  Taught taught;
  writer.commit([&](MemoryTables& tables) {
    const Session session =
        tables.sessions.begin(SessionKind::teach, software_name(), name, opening.now_unix_s);
    taught = teach(tables, session, name, views, settings);
    tables.sessions.end(session.id, 0.0, "kept");
  });
  return taught;
}

}  // namespace striate
