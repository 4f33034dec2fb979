#include "striate/agent/teaching/keep_taught.hpp"

#include "striate/agent/open_memory.hpp"
#include "striate/memory/long_term/memory_writer.hpp"

namespace striate::agent {

memory::Taught keep_taught(const std::string& memory, const std::string& name,
                           const std::vector<memory::StoredView>& views,
                           const memory::LongTermSettings& settings) {
  const memory::MemoryOptions opening = memory_options(memory::Access::session, "striate teach");
  memory::MemoryWriter writer(memory, opening);
  print_notices(writer.notices());
  memory::Taught taught;
  writer.commit([&](memory::MemoryTables& tables) {
    const memory::Session session = tables.sessions.begin(
        memory::SessionKind::teach, software_name(), name, opening.now_unix_s);
    taught = memory::teach(tables, session, name, views, settings);
    tables.sessions.end(session.id, 0.0, "kept");
  });
  return taught;
}

}  // namespace striate::agent
