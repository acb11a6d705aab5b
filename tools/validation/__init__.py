"""Measurements behind docs/validation.md: one module per section, run by tools/validate."""
