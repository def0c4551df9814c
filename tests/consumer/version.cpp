#include <alphamst/alphamst.h>
#include <iostream>

int main() {
    const int expected = AMST_VERSION_MAJOR * 10000 + AMST_VERSION_MINOR * 100 + AMST_VERSION_PATCH;
    std::cout << "AlphaMST " << amst_version_string() << '\n';
    return amst_version() == expected ? 0 : 1;
}
