// Read by moc before each source file: the moc of Qt 6.4 fails in libstdc++'s <concepts> unless some other standard header
// came before it.
#include <utility>
