"""Small dense matrices: the first rows and columns of arrays that may be larger."""


def matrix_set(n: int, value: float, a: 'float[:,:]') -> None:
    """a = value times the identity."""
    for i in range(n):
        for j in range(n):
            a[i, j] = 0.0
        a[i, i] = value


def matrix_copy(n: int, a: 'float[:,:]', c: 'float[:,:]') -> None:
    """c = a."""
    for i in range(n):
        for j in range(n):
            c[i, j] = a[i, j]


def matrix_add(n: int, factor: float, a: 'float[:,:]', c: 'float[:,:]') -> None:
    """c = c + factor * a."""
    for i in range(n):
        for j in range(n):
            c[i, j] = c[i, j] + factor * a[i, j]


def matrix_product(n: int, a: 'float[:,:]', b: 'float[:,:]', c: 'float[:,:]') -> None:
    """c = a b; c is neither of them."""
    for i in range(n):
        for j in range(n):
            total = 0.0
            for k in range(n):
                total = total + a[i, k] * b[k, j]
            c[i, j] = total


def matrix_product_transposed(
    n: int, a: 'float[:,:]', b: 'float[:,:]', c: 'float[:,:]'
) -> None:
    """c = a b^T; c is neither of them."""
    for i in range(n):
        for j in range(n):
            total = 0.0
            for k in range(n):
                total = total + a[i, k] * b[j, k]
            c[i, j] = total


def matrix_transpose(n: int, a: 'float[:,:]', c: 'float[:,:]') -> None:
    """c = a^T; c is not a."""
    for i in range(n):
        for j in range(n):
            c[i, j] = a[j, i]


def matrix_reduce(n: int, columns: int, pivot: int, a: 'float[:,:]', b: 'float[:,:]') -> None:
    """Bring the largest entry of a column to the pivot's row and clear the rows after it."""
    best = pivot
    for i in range(pivot + 1, n):
        if abs(a[i, pivot]) > abs(a[best, pivot]):
            best = i
    for j in range(n):
        kept = a[pivot, j]
        a[pivot, j] = a[best, j]
        a[best, j] = kept
    for j in range(columns):
        kept = b[pivot, j]
        b[pivot, j] = b[best, j]
        b[best, j] = kept
    for i in range(pivot + 1, n):
        factor = a[i, pivot] / a[pivot, pivot]
        for j in range(pivot, n):
            a[i, j] = a[i, j] - factor * a[pivot, j]
        for j in range(columns):
            b[i, j] = b[i, j] - factor * b[pivot, j]


def matrix_solve(n: int, columns: int, a: 'float[:,:]', b: 'float[:,:]') -> None:
    """b = a^-1 b for b with `columns` columns, by elimination; overwrites a."""
    for pivot in range(n):
        matrix_reduce(n, columns, pivot, a, b)
    for step in range(n):
        i = n - 1 - step
        for j in range(columns):
            total = b[i, j]
            for k in range(i + 1, n):
                total = total - a[i, k] * b[k, j]
            b[i, j] = total / a[i, i]
