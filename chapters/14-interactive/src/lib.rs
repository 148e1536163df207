//! A walk through the still life, while it is traced.
