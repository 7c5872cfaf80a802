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


def halvings_below(n: int, time: float, a: 'float[:,:]') -> int:
    """How often a time is halved until a series of exp(a time) converges fast."""
    size = 0.0
    for i in range(n):
        total = 0.0
        for j in range(n):
            total = total + abs(a[i, j])
        size = max(size, total)
    count = 0
    while size * time > 0.5:
        time = 0.5 * time
        count = count + 1
    return count


def matrix_exponential(
    n: int, part: float, a: 'float[:,:]', c: 'float[:,:]', term: 'float[:,:]',
    product: 'float[:,:]',
) -> None:
    """c = exp(a part) by its Taylor series, for a short part; term and product are work space."""
    matrix_set(n, 1.0, c)
    matrix_set(n, 1.0, term)
    for k in range(1, 17):
        matrix_product(n, a, term, product)
        matrix_set(n, 0.0, term)
        matrix_add(n, part / k, product, term)
        matrix_add(n, 1.0, term, c)
