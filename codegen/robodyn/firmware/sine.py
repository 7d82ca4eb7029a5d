"""stand-in"""


def kernel_sine(scalar):
    return {
        "sin": lambda x: x * (1 - x * x * x.dtype.type(0.125)),
        "cos": lambda x: 1 - x * x * x.dtype.type(0.25),
    }
