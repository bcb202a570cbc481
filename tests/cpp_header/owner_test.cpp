// Owners of handles, with handles of no library whose destruction is counted.
#include "destroyed.h"

#include <gtest/gtest.h>

#include <utility>

namespace {

using destroyed::fake;
using Handles = std::vector<void*>;

static_assert(!std::is_copy_constructible_v<agaa::View> && !std::is_copy_assignable_v<agaa::View>);
static_assert(std::is_nothrow_move_constructible_v<agaa::View> && std::is_nothrow_move_assignable_v<agaa::View>);
static_assert(std::is_nothrow_default_constructible_v<agaa::Context> && sizeof(agaa::View) == sizeof(AgaaView));
static_assert(!std::is_convertible_v<AgaaView, agaa::View>, "Ownership is taken explicitly.");

template <class Owner> struct Owners : testing::Test {
    using Handle = decltype(Owner().get());
    Owners() { destroyed::handles().clear(); }
    static Handle handle(size_t number) { return fake<Handle>(number); }
    static Handles takeDestroyed() { return std::exchange(destroyed::handles(), {}); }
};
using Types = testing::Types<agaa::Context, agaa::View>;
TYPED_TEST_SUITE(Owners, Types);

TYPED_TEST(Owners, EmptyOnesDestroyNothing) {
    {
        TypeParam owner;
        EXPECT_FALSE(owner);
        EXPECT_EQ(owner.get(), nullptr);
        EXPECT_EQ(owner.release(), nullptr);
        EXPECT_EQ(owner.reset(), AGAA_OK);
        TypeParam moved(std::move(owner));
        owner = std::move(moved);
    }
    EXPECT_EQ(this->takeDestroyed(), Handles());
}

TYPED_TEST(Owners, DestroyOnce) {
    {
        TypeParam owner(this->handle(1));
        EXPECT_TRUE(owner);
        EXPECT_EQ(owner.get(), this->handle(1));
        EXPECT_EQ(this->takeDestroyed(), Handles());
    }
    EXPECT_EQ(this->takeDestroyed(), Handles{this->handle(1)});
}

TYPED_TEST(Owners, ResetDestroysAtOnce) {
    {
        TypeParam owner(this->handle(1));
        EXPECT_EQ(owner.reset(), AGAA_OK);
        EXPECT_EQ(this->takeDestroyed(), Handles{this->handle(1)});
        EXPECT_FALSE(owner);
        EXPECT_EQ(owner.reset(), AGAA_OK);
    }
    EXPECT_EQ(this->takeDestroyed(), Handles());
}

TYPED_TEST(Owners, ReleaseGivesUp) {
    {
        TypeParam owner(this->handle(1));
        EXPECT_EQ(owner.release(), this->handle(1));
        EXPECT_FALSE(owner);
    }
    EXPECT_EQ(this->takeDestroyed(), Handles());
}

TYPED_TEST(Owners, MovesTransfer) {
    {
        TypeParam first(this->handle(1)), second(this->handle(2));
        TypeParam constructed(std::move(first));
        EXPECT_FALSE(first);
        EXPECT_EQ(constructed.get(), this->handle(1));
        EXPECT_EQ(this->takeDestroyed(), Handles());
        constructed = std::move(second); // destroys its own at once
        EXPECT_FALSE(second);
        EXPECT_EQ(constructed.get(), this->handle(2));
        EXPECT_EQ(this->takeDestroyed(), Handles{this->handle(1)});
    }
    EXPECT_EQ(this->takeDestroyed(), Handles{this->handle(2)});
}

TYPED_TEST(Owners, SelfMoveKeeps) {
    TypeParam owner(this->handle(1));
    TypeParam& same = owner;
    owner = std::move(same);
    EXPECT_EQ(owner.get(), this->handle(1));
    EXPECT_EQ(this->takeDestroyed(), Handles());
}

TYPED_TEST(Owners, Swap) {
    TypeParam first(this->handle(1)), second;
    swap(first, second);
    EXPECT_FALSE(first);
    EXPECT_EQ(second.get(), this->handle(1));
    first.swap(first);
    second.swap(second);
    EXPECT_EQ(second.get(), this->handle(1));
    EXPECT_EQ(this->takeDestroyed(), Handles());
}

TYPED_TEST(Owners, VectorsOfOwners) {
    {
        std::vector<TypeParam> owners;
        for (size_t i = 0; i < 9; ++i)
            owners.emplace_back(this->handle(i));
        owners.erase(owners.begin() + 3);
        EXPECT_EQ(this->takeDestroyed().size(), 1u);
    }
    EXPECT_EQ(this->takeDestroyed().size(), 8u);
}

TEST(OwnersOfBoth, MembersAreDestroyedInTheOrderThatTheLibraryNeeds) {
    destroyed::handles().clear();
    {
        struct Host {
            agaa::Context context{fake<AgaaContext>(0)};
            agaa::View view{fake<AgaaView>(1)};
        } host;
    }
    EXPECT_EQ(destroyed::handles(), (Handles{fake<AgaaView>(1), fake<AgaaContext>(0)}));
}

TEST(OwnersOfBoth, ResultsDestroyValuesThatNobodyTakes) {
    destroyed::handles().clear();
    {
        agaa::Result<agaa::View> result = agaa::View(fake<AgaaView>(1));
        const agaa::Result<agaa::View> moved = std::move(result);
        EXPECT_EQ(moved->get(), fake<AgaaView>(1));
        EXPECT_EQ(destroyed::handles(), Handles());
    }
    EXPECT_EQ(destroyed::handles(), Handles{fake<AgaaView>(1)});
}

TEST(OwnersOfBoth, ContextsWithViewsAreKept) {
    destroyed::handles().clear();
    agaa::Context context(fake<AgaaContext>(5));
    destroyed::refused().push_back(context.get());
    EXPECT_EQ(context.reset(), AGAA_ERROR_WRONG_ORDER);
    EXPECT_EQ(context.get(), fake<AgaaContext>(5));
    EXPECT_DEATH({ agaa::Context gone(std::move(context)); }, "destroyed before its views");
    destroyed::refused().clear();
    EXPECT_EQ(context.reset(), AGAA_OK);
    EXPECT_EQ(destroyed::handles(), Handles{fake<AgaaContext>(5)});
}

} // namespace
