/// A shared object like many: it knows nothing of Striate.
extern "C" int the_answer() {
  return 42;
}
