"""Programs of a page each that use Footfall as a library. Run one: python -m tests.examples.eight_lines"""
