#include "common/input_error.h"
#include "experiments/rivals/methods.h"

#include <catch2/catch.hpp>

#include <string>

using namespace hipmap;

TEST_CASE("rival methods: each is found by its name, others are refused", "[rivals]")
{
    for (const RivalMethod& method : rival_methods())
        CHECK(std::string(rival_method(method.name).name) == method.name);
    CHECK_THROWS_AS(rival_method("metropolis"), InputError);
}
