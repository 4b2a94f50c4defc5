"""The figures of the report, one module each: a diagnosis goes in, pictures as inline SVG come out."""
