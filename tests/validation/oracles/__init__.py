"""Reference solutions that know nothing of the engine: closed forms, ordinary differential equations, published tables."""
