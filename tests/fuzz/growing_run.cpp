// A run that keeps 5 kB of each of its 250 steps, as an engine would that remembers every stranger: the oracle must notice it.
#include "tests/fuzz/oracle.h"

#include <vector>

int main()
{
    const skyseal::test::GrowthWatch growth;
    std::vector<std::vector<char>> kept;
    for (int step = 0; step < 250; ++step) {
        kept.emplace_back(5'000);
        if (step == 50)
            growth.judge(); // a quarter of a megabyte is no growth
    }
    std::puts("judged now");
    std::fflush(stdout);
    growth.judge();
    return 0;
}
