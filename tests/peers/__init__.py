"""Robot dynamics by other people's libraries, and the tests that hold our kernels against them."""
