// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <coroutine>
#include <exception>
#include <optional>
#include <utility>

namespace povpreview {

/// A coroutine that can wait for probes: an algorithm that needs one answer after another reads as
/// a straight line although its caller feeds it the answers one by one. Starts when it is awaited
/// (or by `start()` at the outermost level); owns its frame, so that dropping the outermost routine
/// abandons the algorithm wherever it stands.
template <class T>
class Routine {
   public:
    struct promise_type {
        std::coroutine_handle<> waiting = std::noop_coroutine();
        std::optional<T> value;
        std::exception_ptr fault;

        Routine get_return_object() { return Routine(Handle::from_promise(*this)); }
        std::suspend_always initial_suspend() noexcept { return {}; }
        auto final_suspend() noexcept {
            struct HandOver {
                bool await_ready() noexcept { return false; }
                std::coroutine_handle<> await_suspend(Handle h) noexcept {
                    return h.promise().waiting;
                }
                void await_resume() noexcept {}
            };
            return HandOver{};
        }
        void return_value(T v) { value = std::move(v); }
        void unhandled_exception() { fault = std::current_exception(); }
    };
    using Handle = std::coroutine_handle<promise_type>;

    Routine(Routine&& other) noexcept : handle_(std::exchange(other.handle_, {})) {}
    Routine& operator=(Routine&& other) noexcept {
        std::swap(handle_, other.handle_);
        return *this;
    }
    ~Routine() {
        if (handle_) handle_.destroy();
    }

    void start() { handle_.resume(); }
    bool finished() const { return handle_.done(); }
    /// The value returned; throws what the routine threw. REQUIRES: finished().
    T result() {
        if (handle_.promise().fault) std::rethrow_exception(handle_.promise().fault);
        return std::move(*handle_.promise().value);
    }

    bool await_ready() const noexcept { return false; }
    std::coroutine_handle<> await_suspend(std::coroutine_handle<> caller) noexcept {
        handle_.promise().waiting = caller;
        return handle_;
    }
    T await_resume() { return result(); }

   private:
    explicit Routine(Handle handle) : handle_(handle) {}
    Handle handle_;
};

/// Where a routine waits for one answer.
template <class Question, class Answer>
class Channel {
   public:
    struct Waiting {
        Channel& channel;
        Question question;
        bool await_ready() const noexcept { return false; }
        void await_suspend(std::coroutine_handle<> h) noexcept {
            channel.question_ = question;
            channel.waiting_ = h;
        }
        Answer await_resume() const noexcept { return channel.answer_; }
    };
    Waiting ask(const Question& question) { return {*this, question}; }

    /// The question waited for; nothing once it was taken.
    std::optional<Question> take() { return std::exchange(question_, std::nullopt); }
    /// Gives the answer and runs the routine up to its next question, or its end.
    void answer(const Answer& answer) {
        answer_ = answer;
        std::exchange(waiting_, {}).resume();
    }

   private:
    std::optional<Question> question_;
    Answer answer_{};
    std::coroutine_handle<> waiting_;
};

}  // namespace povpreview
